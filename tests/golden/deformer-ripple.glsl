vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = dot(position.xz, position.xz);
  float t1 = t0 / 90000.0;
  float t2 = t0 + 87.890625;
  float t3 = min(t1, 1.0);
  bool t4 = 1.0 < t1;
  float t5 = sqrt(t2);
  float t6 = 1.0 - t3;
  float t7 = (t5 - millis * 0.06) * 0.0837758;
  float t8 = cos(t7) * ((t2 > 0.0 ? 0.5 / t5 : 0.0) * 0.0837758) * 16.0;
  float t9 = sin(t7) * 16.0;
  float t10 = t6 * t6;
  float t11 = t6 * ((t3 - 1.0) * 2.0) - t10;
  float t12 = t6 * t10;
  float t13 = t9 * (t11 * (t4 ? 0.0 : position.x * 2.2222222e-5));
  float t14 = t9 * (t11 * (t4 ? 0.0 : position.z * 2.2222222e-5));
  float t15 = normal.x - (t12 * (t8 * (position.x * 2.0)) + t13) * normal.y;
  float t16 = normal.z - (t12 * (t8 * (position.z * 2.0)) + t14) * normal.y;
  offset = vec3(0.0, t9 * t12, 0.0);
  float t17 = t15 * t15 + normal.y * normal.y + t16 * t16;
  float t18 = t17 > 0.0 ? inversesqrt(t17) : 0.0;
  warpedNormal = vec3(t15, normal.y, t16) * t18;
  warpedPosition = position + offset;
}
