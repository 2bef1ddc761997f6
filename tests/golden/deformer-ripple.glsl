vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = dot(position.xz, position.xz);
  float t1 = t0 + 87.890625;
  float t2 = t0 / 90000.0;
  float t3 = sqrt(t1);
  float t4 = 1.0 - min(t2, 1.0);
  bool t5 = 1.0 < t2;
  float t6 = (t3 - millis * 0.06) * 0.0837758;
  float t7 = cos(t6) * ((t1 > 0.0 ? 0.5 / t3 : 0.0) * 0.0837758) * 16.0;
  float t8 = sin(t6) * 16.0;
  float t9 = t4 * t4;
  float t10 = t4 * (-t4 - t4) - t9;
  float t11 = t4 * t9;
  float t12 = t8 * (t10 * (t5 ? 0.0 : position.x * 2.2222222e-5));
  float t13 = t8 * (t10 * (t5 ? 0.0 : position.z * 2.2222222e-5));
  float t14 = normal.x - (t11 * (t7 * (position.x * 2.0)) + t12) * normal.y;
  float t15 = normal.z - (t11 * (t7 * (position.z * 2.0)) + t13) * normal.y;
  offset = vec3(0.0, t8 * t11, 0.0);
  float t16 = t14 * t14 + normal.y * normal.y + t15 * t15;
  warpedNormal = vec3(t14, normal.y, t15) * (t16 > 0.0 ? inversesqrt(t16) : 0.0);
  warpedPosition = position + offset;
}
