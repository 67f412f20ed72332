import {
  AmbientLight,
  DirectionalLight,
  HemisphereLight,
  type Light,
  type LightShadow,
  PointLight,
  SpotLight,
  Vector3,
} from 'three';

const world = new Vector3();

/** Texels of a shadow map along a side, in cases that ask for shadows. */
export const SHADOW_SIZE = 512;

/**
 * A plain three light in world space, the same as `source` but for what stock three does not know (`userData.farol`): all
 * competitors get what all can draw. Null for a kind of light that is not measured.
 */
export function copyLight(source: Light): Light | null {
  const copy = make(source);
  if (!copy) return null;
  copy.position.setFromMatrixPosition(source.matrixWorld);
  if (source instanceof DirectionalLight || source instanceof SpotLight) {
    (copy as DirectionalLight).target.position.copy(world.setFromMatrixPosition(source.target.matrixWorld));
  }
  const { shadow } = source as { shadow?: LightShadow };
  if (shadow && source.castShadow) {
    copy.castShadow = true;
    (copy as PointLight).shadow.copy(shadow as PointLight['shadow']);
  }
  return copy;
}

function make(source: Light): Light | null {
  const { color, intensity } = source;
  if (source instanceof AmbientLight) return new AmbientLight(color, intensity);
  if (source instanceof HemisphereLight) return new HemisphereLight(color, source.groundColor, intensity);
  if (source instanceof DirectionalLight) return new DirectionalLight(color, intensity);
  if (source instanceof PointLight) return new PointLight(color, intensity, source.distance, source.decay);
  if (source instanceof SpotLight) {
    return new SpotLight(color, intensity, source.distance, source.angle, source.penumbra, source.decay);
  }
  return null;
}

/** Has a point light cast shadows as the engine's lights do. */
export function castShadow(light: PointLight): void {
  light.castShadow = true;
  light.shadow.mapSize.setScalar(SHADOW_SIZE);
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.02;
}
