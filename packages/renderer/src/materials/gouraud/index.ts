import { forwardTwins } from '../forwardTwin';
import type { TwinKind } from '../TwinKind';
import { beforeLastBrace } from '../../three/beforeLastBrace';
import { replaceChunk } from '../../three/replaceChunk';
import lightLoopVertex from './lightLoopVertex.glsl?raw';

/** The microshaders of Gouraud shading, by name. */
export const microShaders = { lightLoopVertex };

const LIGHT = `vec3 farol_vertexNormal = normalize(transformedNormal);
farol_lightVertex(mvPosition.xyz, farol_vertexNormal, farol_frontSums);
#ifdef DOUBLE_SIDED
farol_lightVertex(mvPosition.xyz, -farol_vertexNormal, farol_backSums);
#endif
`;

/** Changes a forward kind to evaluate lights at the vertices. */
function atVertices(kind: TwinKind): TwinKind {
  return {
    ...kind,
    patch(shader, source, header) {
      kind.patch(shader, source, header);
      const text = replaceChunk(
        shader.vertexShader,
        'clipping_planes_pars_vertex',
        (pars) => `${pars}\n#define FAROL_PER_VERTEX\n${header}`,
      );
      shader.vertexShader = beforeLastBrace(text, LIGHT);
    },
  };
}

/** The forward twins of materials with Gouraud shading, by view. */
export const gouraudTwins = forwardTwins('lightLoopVertex', atVertices);
