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
  float t8 = t7 / t1;
  float t9 = t5 ? 0.0 : t8;
  float t10 = -t6 / t1;
  float t11 = t5 ? 0.0 : t10;
  float t12 = 1.0 - (t5 ? 0.0 : 1.0);
  float t13 = t1 - position.y;
  float t14 = t1 - t13 * t7;
  offset = vec3(t13 * t6 + t4 * t7 - 10.0 - position.x, t14 + t4 * t6 - position.y, 0.0);
  float t15 = t7 * t12 + t4 * t11;
  float t16 = t6 * t12 + t4 * t9;
  float t17 = t13 * t9 + t15;
  float t18 = t16 - t13 * t11;
  vec3 t19 = vec3(t7 * normal.x - t18 * normal.y, t6 * normal.x + t17 * normal.y, (t17 * t7 + t18 * t6) * normal.z);
  float t20 = dot(t19, t19);
  float t21 = inversesqrt(t20);
  warpedNormal = t19 * (t20 > 0.0 ? t21 : 0.0);
  warpedPosition = position + offset;
}
