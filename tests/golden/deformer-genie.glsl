vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = abs(fract(millis / 5000.0) - 0.5) * -1.2;
  float t1 = -(position.y - 215.0);
  float t2 = clamp((t0 + 0.3) / 0.7, 0.0, 1.0);
  float t3 = t2 * t2 * (t2 * -2.0 + 3.0) * 400.0;
  float t4 = clamp((t0 + 0.6) / 0.6, 0.0, 1.0);
  float t5 = t4 * t4 * (t4 * -2.0 + 3.0);
  float t6 = max(t1, 0.0);
  float t7 = min(t6, t3);
  float t8 = t3 < t6 ? 0.0 : -(t1 < 0.0 ? 0.0 : 1.0);
  float t9 = (t1 - t7) / 400.0;
  float t10 = clamp(t9, 0.0, 1.0);
  float t11 = t10 * t10;
  float t12 = t10 * -2.0 + 3.0;
  float t13 = t5 * ((t12 * (t10 * 2.0) + t11 * -2.0) * 0.94);
  float t14 = (mix(0.06, 1.0, t11 * t12) - 1.0) * t5;
  float t15 = t13 * (t9 < 0.0 || t9 > 1.0 ? 0.0 : (-1.0 - t8) * 0.0025);
  float t16 = t14 + 1.0;
  float t17 = (t8 + 1.0) * t16;
  float t18 = position.x - 90.0;
  vec3 t19 = vec3(t17 * normal.x, t16 * t16 * normal.y - t18 * t15 * t16 * normal.x - t16 * (position.z * t15) * normal.z, t17 * normal.z);
  offset = vec3(t18 * t14, t7, position.z * t14);
  float t20 = dot(t19, t19);
  warpedNormal = t19 * (t20 > 0.0 ? inversesqrt(t20) : 0.0);
  warpedPosition = position + offset;
}
