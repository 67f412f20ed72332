import { HalfFloatType, NoBlending, RGFormat, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { PassTarget } from '../../gpu/PassTarget';
import { depthTwin, hasDepthTwin } from '../../materials/depthTwin';
import type { TwinKind } from '../../materials/TwinKind';
import { afterChunkOrAtEnd } from '../../three/replaceChunk';

const WRITE = 'gl_FragColor = vec4(farol_packDistance(vViewPosition.z, isOrthographic), 0.0, 1.0);\nif (true) return;';

/** Writes the distance of surfaces along the view, over the same pixels as `depthTwin` writes depth. */
const distanceTwin: TwinKind = {
  ...depthTwin,
  key: 'surface-distance',
  chunks: () => ['storedDistance'],
  properties: { blending: NoBlending },
  patch(shader, _source, header) {
    const { fragmentShader } = shader;
    shader.fragmentShader = `${header}\n${afterChunkOrAtEnd(fragmentShader, 'alphahash_fragment', WRITE)}`;
  },
};

/** Draws the distances of surfaces after a depth pre-pass, whose depth does not tell them. */
export class DistancePass {
  private readonly target = new PassTarget({ format: RGFormat, type: HalfFloatType, depthTexture: true });

  get bytes(): number {
    return this.target.bytes;
  }

  /** @returns distances of the picture's size, as storedDistance.glsl packs them */
  render(frame: Frame): Texture {
    const target = this.target.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(1, true);
    for (const item of frame.queue.opaque) {
      if (item.route === 'split' && hasDepthTwin(item.material)) frame.drawTwin(item, distanceTwin);
    }
    return target.texture;
  }

  dispose(): void {
    this.target.dispose();
  }
}
