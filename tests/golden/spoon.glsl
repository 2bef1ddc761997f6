vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x + 10.0;
  float t1 = 1.0 / (sin(millis / 1500.0) * 0.018 + 0.0185);
  float t2 = clamp(t0, 0.0, 50.0);
  float t3 = t2 / t1;
  float t4 = t0 - t2;
  bool t5 = t0 < 0.0 || t0 > 50.0;
  float t6 = sin(t3);
  float t7 = cos(t3);
  float t8 = t1 - position.y;
  float t9 = 1.0 - (t5 ? 0.0 : 1.0);
  float t10 = t5 ? 0.0 : t7 / t1;
  float t11 = t5 ? 0.0 : -t6 / t1;
  float t12 = t1 - t8 * t7;
  offset = vec3(t8 * t6 + t4 * t7 - 10.0 - position.x, t12 + t4 * t6 - position.y, 0.0);
  float t13 = t7 * t9 + t4 * t11;
  float t14 = t6 * t9 + t4 * t10;
  float t15 = t8 * t10 + t13;
  float t16 = t8 * t11;
  float t17 = (t14 - t16) * t6;
  vec3 t18 = vec3(t7 * normal.x + (t16 - t14) * normal.y, t6 * normal.x + t15 * normal.y, (t15 * t7 + t17) * normal.z);
  float t19 = dot(t18, t18);
  float t20 = t19 > 0.0 ? inversesqrt(t19) : 0.0;
  warpedNormal = t18 * t20;
  warpedPosition = position + offset;
}
