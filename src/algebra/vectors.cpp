#include "algebra/vectors.hpp"

namespace warpjet {

Expression sum(const Value& v) {
  Expression total = v[0];
  for (int i = 1; i < v.size(); ++i) total = total + v[i];
  return total;
}

Expression dot(const Value& a, const Value& b) { return sum(a * b); }

Value cross(const Value& a, const Value& b) {
  return fill(a.graph(), vectorOf(3), [&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
  });
}

Expression length(const Value& v) { return sqrt(dot(v, v)); }

Value normalize(const Value& v) {
  const Expression squared = dot(v, v);
  return v * ifElse(gt(squared, 0.0), inversesqrt(squared), 0.0);
}

Value reflect(const Value& incident, const Value& normal) {
  return incident - normal * (dot(normal, incident) * 2.0);
}

Value refract(const Value& incident, const Value& normal, Expression eta) {
  const Expression along = dot(normal, incident);
  const Expression k = 1.0 - eta * eta * (1.0 - along * along);
  const Value refracted = incident * eta - normal * (eta * along + sqrt(k));
  return fill(incident.graph(), incident.shape(),
              [&](int i) { return ifElse(lt(k, 0.0), 0.0, refracted[i]); });
}

Value faceforward(const Value& normal, const Value& incident, const Value& reference) {
  return normal * ifElse(lt(dot(reference, incident), 0.0), 1.0, -1.0);
}

Value smoothstep(const Value& low, const Value& high, const Value& x) {
  const Value ratio = (x - low) / (high - low);
  const Value t =
      byComponent(ops::find("clamp"), std::array{ratio, constantLike(x, 0), constantLike(x, 1)});
  return t * t * (t * -2.0 + constantLike(x, 3));
}

}  // namespace warpjet
