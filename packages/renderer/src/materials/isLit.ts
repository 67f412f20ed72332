import type { Material, ShaderMaterial } from 'three';

type AnyMaterial = Material & {
  isMeshStandardMaterial?: boolean;
  isMeshLambertMaterial?: boolean;
  isMeshPhongMaterial?: boolean;
  isMeshToonMaterial?: boolean;
  isShaderMaterial?: boolean;
};

/** True for materials lit by three's light loop: the built-in ones, and shader materials that include its lights chunk. */
export function isLit(material: Material): boolean {
  const m = material as AnyMaterial;
  if (m.isMeshStandardMaterial || m.isMeshLambertMaterial || m.isMeshPhongMaterial || m.isMeshToonMaterial) return true;
  if (!m.isShaderMaterial) return false;
  const shader = material as ShaderMaterial;
  const text = shader.fragmentShader;
  return (
    shader.lights === true &&
    text.includes('#include <lights_pars_begin>') &&
    text.includes('#include <lights_fragment_begin>')
  );
}
