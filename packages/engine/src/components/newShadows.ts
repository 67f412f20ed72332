/** Shadow flags of new meshes: as in other editors, they cast and receive shadows. */
export const meshShadows = { castShadow: true, receiveShadow: true } as const;

/** Size of the shadow map (texels) and softness of new lights, by their type. */
export const lightShadows = {
  directional: { castShadow: true, shadowMapSize: 2048, shadowRadius: 2 },
  /** Six maps each: only lights that are chosen to throw shadows do. */
  point: { castShadow: false, shadowMapSize: 512, shadowRadius: 2 },
  spot: { castShadow: true, shadowMapSize: 1024, shadowRadius: 2 },
} as const;
