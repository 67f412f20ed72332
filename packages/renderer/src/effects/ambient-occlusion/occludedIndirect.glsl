{
  float farol_open = texelFetch(farol_occlusionMap, ivec2(gl_FragCoord.xy - farol_occlusionOffset), 0).r;
  reflectedLight.indirectDiffuse *= farol_open;
  #if defined( USE_CLEARCOAT )
    clearcoatSpecularIndirect *= farol_open;
  #endif
  #if defined( USE_SHEEN )
    sheenSpecularIndirect *= farol_open;
  #endif
  #if defined( STANDARD )
    reflectedLight.indirectSpecular *= mix(1.0, farol_open, material.roughness);
  #endif
}
