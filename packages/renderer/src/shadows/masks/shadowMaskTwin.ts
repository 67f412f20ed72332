import type { Material, ShaderMaterial } from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { replaceChunk } from '../../three/replaceChunk';
import type { TwinKind, TwinShader } from '../../materials/TwinKind';

const PARS = '#include <shadowmask_pars_fragment>';
const MARK = '// farol_shadowmask_pars';
const VARYINGS = 'varying highp vec3 farol_maskPositionVS;\nvarying highp vec3 farol_maskNormalVS;\n';

/** Twin of ShadowMaterial and shader materials like it: Farol's shadows times those that three draws. */
export const shadowMaskTwin: TwinKind = {
  key: 'shadow-mask',
  chunks: () => ['shadowMask'],
  patch(shader: TwinShader, _source: Material, header: string) {
    // three's own chunk defines the function that is renamed here, so the chunk is inserted after the calls are replaced
    shader.fragmentShader = replaceChunk(shader.fragmentShader, 'shadowmask_pars_fragment', () => MARK)
      .replace(/\bgetShadowMask\s*\(\s*\)/g, '(getShadowMask() * farol_shadowMask())')
      .replace(MARK, () => `${PARS}\n${header}`);
    shader.vertexShader = `${VARYINGS}${beforeLastBrace(
      shader.vertexShader,
      'farol_maskPositionVS = mvPosition.xyz; farol_maskNormalVS = normalize(transformedNormal);',
    )}`;
  },
};

type MaskMaterial = ShaderMaterial & { isShadowMaterial?: boolean };

/** True for materials that show shadows by three's `getShadowMask()` and have no light loop. */
export function showsShadowMask(material: Material): boolean {
  const m = material as MaskMaterial;
  if (m.isShadowMaterial === true) return true;
  return (
    m.isShaderMaterial === true &&
    m.lights === true &&
    m.fragmentShader.includes(PARS) &&
    m.vertexShader.includes('#include <project_vertex>') &&
    m.vertexShader.includes('#include <defaultnormal_vertex>')
  );
}
