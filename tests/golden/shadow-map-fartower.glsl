vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y * 5.0 + millis / 700.0;
  float t1 = sin(t0);
  float t2 = cos(t0);
  float t3 = normal.y - t2 * 2.0 * normal.x - t1 * -2.0 * normal.z;
  offset = vec3(t1 * 0.4, 0.0, t2 * 0.4);
  float t4 = normal.x * normal.x + t3 * t3 + normal.z * normal.z;
  float t5 = inversesqrt(t4);
  warpedNormal = vec3(normal.x, t3, normal.z) * (t4 > 0.0 ? t5 : 0.0);
  warpedPosition = position + offset;
}
