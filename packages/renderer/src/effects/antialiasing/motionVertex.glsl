vec3 farol_position = vec3(position);
#if defined( USE_MORPHTARGETS )
  #ifdef USE_INSTANCING_MORPH
    farol_position *= morphTargetBaseInfluence;
    for (int i = 0; i < MORPHTARGETS_COUNT; i++)
      farol_position += getMorph(gl_VertexID, i, 0).xyz * morphTargetInfluences[i];
  #else
    farol_position *= farol_morphBaseBefore;
    for (int i = 0; i < MORPHTARGETS_COUNT; i++)
      farol_position += getMorph(gl_VertexID, i, 0).xyz * farol_morphsBefore[i];
  #endif
#endif
#ifdef FAROL_DISPLACE_BEFORE
  VertexData farol_vertexBefore = VertexData(farol_position, vec3(normal), uv, 0.0);
  FAROL_DISPLACE_BEFORE(farol_vertexBefore)
  farol_position = farol_vertexBefore.positionOS;
#endif
vec4 farol_there = vec4(farol_position, 1.0);
#ifdef USE_SKINNING
  farol_there = bindMatrix * farol_there;
  farol_there = farol_matrixOf(farol_bonesBefore, int(skinIndex.x)) * farol_there * skinWeight.x
    + farol_matrixOf(farol_bonesBefore, int(skinIndex.y)) * farol_there * skinWeight.y
    + farol_matrixOf(farol_bonesBefore, int(skinIndex.z)) * farol_there * skinWeight.z
    + farol_matrixOf(farol_bonesBefore, int(skinIndex.w)) * farol_there * skinWeight.w;
#endif
#ifdef USE_DISPLACEMENTMAP
  farol_there.xyz += normalize(objectNormal)
    * (texture2D(displacementMap, vDisplacementMapUv).x * displacementScale + displacementBias);
#endif
#ifdef USE_BATCHING
  farol_there = farol_matrixOf(farol_instancesBefore, int(getIndirectIndex(gl_DrawID))) * farol_there;
#endif
#ifdef USE_INSTANCING
  farol_there = farol_matrixOf(farol_instancesBefore, gl_InstanceID) * farol_there;
#endif
farol_before = farol_clipBefore * farol_there;
farol_now = vec4(gl_Position.xy - farol_jitter * gl_Position.w, gl_Position.zw);
