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

/** Size of a shadow map in cases with shadows (texels per side). */
export const SHADOW_SIZE = 512;

/**
 * Copies a light as a plain three light in world space, without Farol's options (`userData.farol`), which other
 * competitors do not support.
 *
 * @returns null for a kind of light that is not measured
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

/** Makes a point light cast shadows, with the biases of the engine's lights. */
export function castShadow(light: PointLight): void {
  light.castShadow = true;
  light.shadow.mapSize.setScalar(SHADOW_SIZE);
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.02;
}
