vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = 1.0 / (sin(millis / 1500.0) * 0.018 + 0.0185);
  float t1 = position.x + 10.0;
  float t2 = clamp(t1, 0.0, 50.0);
  bool t3 = t1 < 0.0 || t1 > 50.0;
  float t4 = t1 - t2;
  float t5 = 1.0 - (t3 ? 0.0 : 1.0);
  float t6 = t2 / t0;
  float t7 = t3 ? 0.0 : 1.0 / t0;
  float t8 = sin(t6);
  float t9 = cos(t6);
  float t10 = t9 * t7;
  float t11 = t8 * t7;
  float t12 = t0 - position.y;
  float t13 = t12 * t10 + (t9 * t5 - t4 * t11);
  float t14 = t12 * t11 + (t8 * t5 + t4 * t10);
  float t15 = t9 * normal.x - t14 * normal.y;
  float t16 = t8 * normal.x + t13 * normal.y;
  float t17 = (t13 * t9 + t14 * t8) * normal.z;
  float t18 = t15 * t15 + t16 * t16 + t17 * t17;
  float t19 = t18 > 0.0 ? inversesqrt(t18) : 0.0;
  offset = vec3(t12 * t8 + t4 * t9 - 10.0 - position.x, t0 - t12 * t9 + t4 * t8 - position.y, 0.0);
  warpedPosition = position + offset;
  warpedNormal = vec3(t15 * t19, t16 * t19, t17 * t19);
}
