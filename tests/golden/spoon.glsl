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
  float t8 = 1.0 - (t5 ? 0.0 : 1.0);
  float t9 = t5 ? 0.0 : t7 / t1;
  float t10 = t5 ? 0.0 : -t6 / t1;
  float t11 = t1 - position.y;
  float t12 = t1 - t11 * t7;
  offset = vec3(t11 * t6 + t4 * t7 - 10.0 - position.x, t12 + t4 * t6 - position.y, 0.0);
  float t13 = t7 * t8 + t4 * t10;
  float t14 = t6 * t8 + t4 * t9;
  float t15 = t11 * t9 + t13;
  float t16 = t14 - t11 * t10;
  vec3 t17 = vec3(t7 * normal.x - t16 * normal.y, t6 * normal.x + t15 * normal.y, (t15 * t7 + t16 * t6) * normal.z);
  float t18 = dot(t17, t17);
  warpedNormal = t17 * (t18 > 0.0 ? inversesqrt(t18) : 0.0);
  warpedPosition = position + offset;
}
