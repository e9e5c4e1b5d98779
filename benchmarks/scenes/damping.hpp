#pragma once

#include <string>
#include <vector>

#include "chain.hpp"
#include "scene.hpp"

namespace fde {

// The damping mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u of Yin, Liu & Anh (5.1), (6.2),
// as terms.
std::vector<Term> damping_terms(const Parameters& p, double mu, double lambda, double nu);

// The orders alpha, beta and the time tau, with the defaults of section 7.
std::vector<Parameter> damping_parameters();

// Columns u, Dbeta_u, du, Dalpha_u of a chain that stands at offset in the problem; what the chain dropped is
// left out.
Outputs chain_outputs(const Chain& chain, const std::vector<Term>& terms, const std::string& u,
                      Eigen::Index offset = 0);

}  // namespace fde
