vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = cos(millis / 1500.0) * 2.6 / 150.0;
  float t1 = t0 * position.y;
  float t2 = cos(t1);
  float t3 = sin(t1);
  float t4 = t3 * t0;
  float t5 = t2 * t0;
  float t6 = position.z * t5 - position.x * t4;
  float t7 = -position.z * t4 - position.x * t5;
  float t8 = (t7 * t3 - t6 * t2) * normal.x + (t2 * t2 + t3 * t3) * normal.y + (-t3 * t6 - t2 * t7) * normal.z;
  float t9 = t2 * normal.x + t3 * normal.z;
  float t10 = t2 * normal.z - t3 * normal.x;
  float t11 = t2 - 1.0;
  offset = vec3(position.x * t11 + position.z * t3, 0.0, position.z * t11 - position.x * t3);
  float t12 = t9 * t9 + t8 * t8 + t10 * t10;
  float t13 = t12 > 0.0 ? inversesqrt(t12) : 0.0;
  warpedNormal = vec3(t9 * t13, t8 * t13, t10 * t13);
  warpedPosition = position + offset;
}
