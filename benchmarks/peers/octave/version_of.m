% SPDX-License-Identifier: MIT
% The revision, or the date of the release, in the header of a code; empty without one.
function version = version_of(file)
  text = fileread(file);
  text(double(text) > 127) = " "; % some headers are not UTF-8, which regexp wants
  version = "";
  for pattern = {'Revision:\s*([\d.]+)', 'Version of ([A-Z]\w+, \d+ \d{4})', 'Rel\. (\d{4}-\d\d-\d\d)'}
    found = regexp(text, pattern{1}, "tokens", "once");
    if ! isempty(found)
      version = found{1};
      return;
    end
  end
end
