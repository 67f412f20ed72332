/** Shadow flags of new meshes: as in other editors, they cast and receive shadows. */
export const meshShadows = { castShadow: true, receiveShadow: true } as const;

/** Size of the shadow map (texels) and softness of new lights, by their type. */
export const lightShadows = {
  directional: { castShadow: true, shadowMapSize: 2048, shadowRadius: 2 },
  /** off by default: a point light draws six shadow maps */
  point: { castShadow: false, shadowMapSize: 512, shadowRadius: 2 },
  spot: { castShadow: true, shadowMapSize: 1024, shadowRadius: 2 },
} as const;

/**
 * Shadows of a sun over a square of the ground. Cascades, which keep shadows fine near the camera, allow a square whose
 * edge is out of sight. The bias is a share of the shadow camera's depth, which grows with the extent.
 * @param extent - half the width of the square (m)
 */
export const sunShadows = (extent: number) => ({
  ...lightShadows.directional,
  shadowExtent: extent,
  shadowBias: -0.01 / extent,
});
