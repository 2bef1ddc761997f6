vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.02 + millis / 1000.0;
  float t1 = cos(t0);
  float t2 = sin(t0);
  float t3 = position.z + 500.0;
  float t4 = t2 * -0.02;
  float t5 = t1 * 0.02;
  float t6 = position.y * t4 - t3 * t5;
  float t7 = position.y * t5 + t3 * t4;
  float t8 = (t1 * t1 + t2 * t2) * normal.x + (-t2 * t7 - t1 * t6) * normal.y + (t6 * t2 - t7 * t1) * normal.z;
  offset = vec3(0.0, position.y * t1 - t3 * t2 - position.y, position.y * t2 + t3 * t1 - 500.0 - position.z);
  float t9 = t1 * normal.y - t2 * normal.z;
  float t10 = t2 * normal.y + t1 * normal.z;
  float t11 = t8 * t8 + t9 * t9 + t10 * t10;
  float t12 = t11 > 0.0 ? inversesqrt(t11) : 0.0;
  warpedNormal = vec3(t8 * t12, t9 * t12, t10 * t12);
  warpedPosition = position + offset;
}
