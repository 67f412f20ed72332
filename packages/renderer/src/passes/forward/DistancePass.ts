import { HalfFloatType, NoBlending, RGFormat, Vector4, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { isPlain, type RenderItem } from '../../frame/RenderItem';
import { PassTarget } from '../../gpu/PassTarget';
import { depthTwin, hasDistanceTwin } from '../../materials/depthTwin';
import type { TwinKind } from '../../materials/TwinKind';
import { afterChunkOrAtEnd, replaceChunk } from '../../three/replaceChunk';

/** Value of pixels without a surface: near the largest half float. */
const NOWHERE = new Vector4(6e4, 0, 0, 0);
const WRITE = 'gl_FragColor = vec4(farol_packDistance(farol_away, isOrthographic), 0.0, 1.0);\nif (true) return;';

/** Twin that writes the distance of surfaces along the view, for the same pixels as `depthTwin`. */
const distanceTwin: TwinKind = {
  ...depthTwin,
  key: 'surface-distance',
  chunks: () => ['storedDistance'],
  properties: { blending: NoBlending },
  patch(shader, _source, header) {
    const { vertexShader, fragmentShader } = shader;
    const vertex = replaceChunk(vertexShader, 'project_vertex', (text) => `${text}\nfarol_away = -mvPosition.z;`);
    shader.vertexShader = `out highp float farol_away;\n${vertex}`;
    const written = afterChunkOrAtEnd(fragmentShader, 'alphahash_fragment', WRITE);
    shader.fragmentShader = `in highp float farol_away;\n${header}\n${written}`;
  },
};

/** True for an opaque item with three's own shader, whose distance a twin can write. */
export function drawsDistance(item: RenderItem): boolean {
  return isPlain(item) && !item.ownShader && hasDistanceTwin(item.material);
}

/** Draws the distances of surfaces where depth does not give them. */
export class DistancePass {
  /** @param draws - tests whether to draw an opaque item's distances */
  constructor(private readonly draws: (item: RenderItem) => boolean = drawsDistance) {}

  private readonly target = new PassTarget({ format: RGFormat, type: HalfFloatType, depthTexture: true });

  get bytes(): number {
    return this.target.bytes;
  }

  /** @returns target of the picture's size: distances packed by storedDistance.glsl, and depth */
  render(frame: Frame): WebGLRenderTarget {
    const target = this.target.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(1, true, NOWHERE);
    for (const item of frame.queue.opaque) {
      if (this.draws(item)) frame.drawTwin(item, distanceTwin);
    }
    return target;
  }

  dispose(): void {
    this.target.dispose();
  }
}
