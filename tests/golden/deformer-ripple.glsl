vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * position.x + position.z * position.z;
  float t1 = t0 / 90000.0;
  float t2 = t0 + 87.890625;
  float t3 = min(t1, 1.0);
  bool t4 = 1.0 < t1;
  float t5 = sqrt(t2);
  float t6 = 1.0 - t3;
  float t7 = t3 - 1.0;
  float t8 = (t5 - millis * 0.06) * 0.0837758;
  float t9 = cos(t8) * ((t2 > 0.0 ? 0.5 / t5 : 0.0) * 0.0837758) * 16.0;
  float t10 = sin(t8) * 16.0;
  float t11 = t6 * t6;
  float t12 = t6 * (t7 + t7) - t11;
  float t13 = t6 * t11;
  float t14 = position.x + position.x;
  float t15 = position.z + position.z;
  float t16 = t10 * (t12 * (t4 ? 0.0 : t14 * 1.1111111e-5));
  float t17 = t10 * (t12 * (t4 ? 0.0 : t15 * 1.1111111e-5));
  float t18 = normal.x - (t13 * (t9 * t14) + t16) * normal.y;
  float t19 = normal.z - (t13 * (t9 * t15) + t17) * normal.y;
  offset = vec3(0.0, t10 * t13, 0.0);
  float t20 = t18 * t18 + normal.y * normal.y + t19 * t19;
  float t21 = t20 > 0.0 ? inversesqrt(t20) : 0.0;
  warpedNormal = vec3(t18 * t21, normal.y * t21, t19 * t21);
  warpedPosition = position + offset;
}
