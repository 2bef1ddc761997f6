vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = clamp(sin(millis / 900.0) * 1.5 + 0.5, 0.0, 0.97);
  float t1 = 1.0 - t0;
  offset = vec3(-position.x * t0, 0.0, 0.0);
  float t2 = t1 * normal.y;
  float t3 = t1 * normal.z;
  float t4 = normal.x * normal.x + t2 * t2 + t3 * t3;
  float t5 = inversesqrt(t4);
  warpedNormal = vec3(normal.x, t2, t3) * (t4 > 0.0 ? t5 : 0.0);
  warpedPosition = position + offset;
}
