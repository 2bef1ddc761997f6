vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = cos(millis / 1500.0) * 2.6 / 150.0;
  float t1 = (position.y - 20.0) / -40.0;
  float t2 = t0 * position.y;
  float t3 = clamp(t1, 0.0, 1.0);
  float t4 = cos(t2);
  float t5 = sin(t2);
  float t6 = t3 * t3;
  float t7 = t3 * -2.0 + 3.0;
  float t8 = (t7 * (t3 * 2.0) + t6 * -2.0) * (t1 < 0.0 || t1 > 1.0 ? 0.0 : -0.025);
  float t9 = t6 * t7;
  float t10 = t4 - 1.0;
  float t11 = t4 * t0;
  float t12 = t5 * t0;
  float t13 = position.x * t10 + position.z * t5;
  float t14 = position.z * t10 - position.x * t5;
  float t15 = t9 * t5;
  float t16 = t9 * t10 + 1.0;
  float t17 = t9 * (position.z * t11 - position.x * t12);
  float t18 = t9 * (-position.z * t12 - position.x * t11);
  float t19 = t17 + t13 * t8;
  float t20 = t18 + t14 * t8;
  vec3 t21 = vec3(t16 * normal.x + t15 * normal.z, (t20 * t15 - t19 * t16) * normal.x + (t16 * t16 + t15 * t15) * normal.y + (-t15 * t19 - t16 * t20) * normal.z, t16 * normal.z - t15 * normal.x);
  offset = vec3(t13 * t9, 0.0, t14 * t9);
  float t22 = dot(t21, t21);
  warpedNormal = t21 * (t22 > 0.0 ? inversesqrt(t22) : 0.0);
  warpedPosition = position + offset;
}
