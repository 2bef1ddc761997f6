vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = max(sin(millis / 350.0) * 0.45 + 1.0, 0.01);
  float t1 = inversesqrt(t0);
  float t2 = t0 * t1;
  float t3 = t2 * normal.x;
  float t4 = t2 * normal.z;
  float t5 = t1 * t1 * normal.y;
  float t6 = t1 - 1.0;
  offset = vec3(position.x * t6, (position.y - 100.0) * (t0 - 1.0), position.z * t6);
  float t7 = t3 * t3 + t5 * t5 + t4 * t4;
  float t8 = t7 > 0.0 ? inversesqrt(t7) : 0.0;
  warpedNormal = vec3(t3 * t8, t5 * t8, t4 * t8);
  warpedPosition = position + offset;
}
