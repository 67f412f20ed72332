import type { IUniform, Material } from 'three';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { findChunk } from '../../three/replaceChunk';
import type { TwinKind } from '../../materials/TwinKind';
import occludedIndirect from './occludedIndirect.glsl?raw';

function warnOf({ name, type }: Material): void {
  console.warn(
    `Farol: ambient occlusion does not darken the material "${name || type}": its onBeforeCompile removes #include <aomap_fragment>; keep that line.`,
  );
}

const UNIFORMS = 'uniform highp sampler2D farol_occlusionMap;\nuniform highp vec2 farol_occlusionOffset;\n';

/**
 * Kind of twin (Farol's material for the host's) of a forward draw, its indirect light darkened by ambient occlusion.
 * @param uniforms - farol_occlusionMap, at full resolution, and farol_occlusionOffset (pixels)
 */
export function occludedTwin(kind: TwinKind, uniforms: Record<string, IUniform>): TwinKind {
  return {
    ...kind,
    key: `${kind.key}-occluded`,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      Object.assign(shader.uniforms, uniforms);
      const after = findChunk(shader.fragmentShader, 'aomap_fragment');
      if (after === null) return warnOf(source);
      shader.fragmentShader = UNIFORMS + shader.fragmentShader.replace(after, () => `${after}\n${occludedIndirect}`);
    },
  };
}

const INDIRECT = `#if defined( STANDARD )
farol_outIndirect = vec4(reflectedLight.indirectDiffuse + material.roughness * reflectedLight.indirectSpecular, 0.0);
#else
farol_outIndirect = vec4(reflectedLight.indirectDiffuse, 0.0);
#endif`;

/** Twin kind of a G-buffer draw that also writes its indirect light to the attachment `location`. */
export function indirectTwin(kind: TwinKind, location: number): TwinKind {
  return {
    ...kind,
    key: `${kind.key}-indirect-${location}`,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      shader.fragmentShader = `layout(location = ${location}) out highp vec4 farol_outIndirect;\n${beforeLastBrace(shader.fragmentShader, INDIRECT)}`;
    },
  };
}
