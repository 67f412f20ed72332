import type { IUniform } from 'three';
import { findChunk } from '../../three/replaceChunk';
import type { TwinKind } from '../../materials/TwinKind';
import probeIrradiance from './probeIrradiance.glsl?raw';

/** Matches the head of main(), with any spacing that the host's shader may have. */
const MAIN = /\bvoid\s+main\s*\(/;

/** Puts declarations before a shader's main(). */
const beforeMain = (shader: string, declarations: string): string =>
  shader.replace(MAIN, (main) => `${declarations}\n${main}`);

/** GLSL that adds the probes' light; `irradiance` and `iblIrradiance` are variables of three's lights_fragment_begin. */
const ADD = `#if defined( RE_IndirectDiffuse )
#ifndef USE_LIGHTMAP
irradiance += farol_probeIrradiance(geometryPosition, geometryNormal);
#endif
iblIrradiance *= farol_environmentShare;
#endif`;

/**
 * Kind of twin (material in place of the host's) that adds the light of probes to a lit material without a lightmap.
 * @param uniforms - uniforms of probeIrradiance.glsl
 */
export function probedTwin(kind: TwinKind, uniforms: Record<string, IUniform>): TwinKind {
  return {
    ...kind,
    key: `${kind.key}-probes`,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      const { fragmentShader } = shader;
      // a host's shader without three's map chunk gets no ambient light from probes either
      const maps = findChunk(fragmentShader, 'lights_fragment_maps');
      if (maps === null) return;
      Object.assign(shader.uniforms, uniforms);
      shader.fragmentShader = beforeMain(
        fragmentShader.replace(maps, () => `${maps}\n${ADD}`),
        probeIrradiance,
      );
    },
  };
}
