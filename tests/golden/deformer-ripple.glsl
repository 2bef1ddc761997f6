vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = dot(position.xz, position.xz);
  float t1 = t0 + 87.890625;
  float t2 = t0 / 90000.0;
  float t3 = sqrt(t1);
  float t4 = 1.0 - min(t2, 1.0);
  bool t5 = 1.0 < t2;
  float t6 = (t3 - millis * 0.06) * 0.0837758;
  float t7 = 0.5 / t3;
  float t8 = cos(t6) * ((t1 > 0.0 ? t7 : 0.0) * 0.0837758) * 16.0;
  float t9 = sin(t6) * 16.0;
  float t10 = t4 * t4;
  float t11 = position.x * 2.2222222e-5;
  float t12 = position.z * 2.2222222e-5;
  float t13 = t4 * (-t4 - t4) - t10;
  float t14 = t4 * t10;
  float t15 = t9 * (t13 * (t5 ? 0.0 : t11));
  float t16 = t9 * (t13 * (t5 ? 0.0 : t12));
  float t17 = normal.x - (t14 * (t8 * (position.x * 2.0)) + t15) * normal.y;
  float t18 = normal.z - (t14 * (t8 * (position.z * 2.0)) + t16) * normal.y;
  offset = vec3(0.0, t9 * t14, 0.0);
  float t19 = t17 * t17 + normal.y * normal.y + t18 * t18;
  vec3 t20 = vec3(t17, normal.y, t18) * inversesqrt(t19);
  warpedNormal = t19 > 0.0 && t19 < 1e38 ? t20 : vec3(0.0);
  warpedPosition = position + offset;
}
