vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 2000.0) * 0.5 + 0.5;
  float t1 = t0 * 1.6 - position.y * 0.004 - 0.5;
  float t2 = t0 * 1.4 + position.x * 0.003 - 0.4;
  float t3 = clamp(t1, 0.0, 1.0);
  float t4 = t3 * t3;
  float t5 = (t4 + t3 * (t3 + t3)) * (t1 < 0.0 || t1 > 1.0 ? 0.0 : -0.004);
  float t6 = t3 * t4;
  float t7 = clamp(t2, 0.0, 1.0);
  float t8 = t7 * t7;
  float t9 = (150.0 - position.y) * ((t8 + t7 * (t7 + t7)) * (t2 < 0.0 || t2 > 1.0 ? 0.0 : 0.003));
  float t10 = t7 * t8;
  float t11 = 1.0 - t6;
  offset = vec3(mix(position.x, 120.0, t6) - position.x, mix(position.y, 150.0, t10) - position.y, position.z * t11 - position.z);
  float t12 = (1.0 - t10) * t11;
  float t13 = (120.0 - position.x) * t5;
  float t14 = position.z * t5;
  float t15 = (t12 - t9 * t13) * normal.z;
  float t16 = t12 * normal.x - t11 * t9 * normal.y - t9 * t14 * normal.z;
  float t17 = t11 * t11 * normal.y - t13 * t11 * normal.x + t11 * t14 * normal.z;
  float t18 = t16 * t16 + t17 * t17 + t15 * t15;
  float t19 = t18 > 0.0 ? inversesqrt(t18) : 0.0;
  warpedNormal = vec3(t16 * t19, t17 * t19, t15 * t19);
  warpedPosition = position + offset;
}
