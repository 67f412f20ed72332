import {
  HalfFloatType,
  LessEqualDepth,
  LinearFilter,
  NearestFilter,
  type Texture,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { fitTargetTo } from '../../gpu/fitTarget';
import { forwardTwins } from '../../materials/forwardTwin';
import { plainWhole } from '../../materials/plainTwins';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { targetBytes } from '../../gpu/targetBytes';
import type { RenderItem } from '../../frame/RenderItem';
import { Picture } from '../Picture';
import edgeBackground from './edgeBackground.glsl?raw';
import edgeColor from './edgeColor.glsl?raw';
import edgeResolve from './edgeResolve.glsl?raw';
import { edgeTwin } from './edgeTwin';
import { hasMotionTwin } from './motionTwin';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../../three/drawnAsCanvas';
import { framebufferHandle, multisampledFramebufferHandle } from '../../three/handles';
import { bindFramebuffer, isDepthReversed } from '../../three/state';

const SAMPLES = 4;

/**
 * Multisampled edges over any technique: the geometry is drawn again, with 4 samples a pixel. Samples of the surface
 * that the finished picture shows in the pixel take the picture's colour; other samples are shaded, as stock three does
 * with `antialias: true`. No earlier frame is used, so moving objects have smooth edges too and leave no ghosts.
 *
 * Shading goes through all lights. With more of them than `shadedLights`, with ambient occlusion or decals, or under
 * transparent objects that write no depth, the colour is that of a nearby pixel which shows the surface; surfaces that
 * no nearby pixel shows are still shaded, up to `mostLights`. Not smoothed: points, lines, sprites, materials with the
 * host's own shader, stencil or depth function, and transparent objects. `SMAA` and `TAA` must not be used with it.
 * @see Chajdas, McGuire and Luebke 2011, Subpixel Reconstruction Antialiasing, https://doi.org/10.1145/1944745.1944748
 */
export class MultisampledEdges implements FarolEffect {
  readonly name = 'Multisampled edges';
  readonly lacks = lacksFloatTargets;
  readonly takesPicture = true;
  readonly smoothsEdges = true;
  /** Maximum number of lights with which all edges are shaded. Default 32. */
  shadedLights = 32;
  /** Number of lights above which no edge is shaded: surfaces that no nearby pixel shows keep the picture's edges. Default 128. */
  mostLights = 128;
  private readonly picture = { value: null as Texture | null };
  private readonly depth = { value: null as Texture | null };
  private readonly whole = { value: true };
  private readonly reuse = { value: false };
  private readonly shades = { value: true };
  private readonly size = { value: new Vector2() };
  private readonly uniforms = {
    farol_picture: this.picture,
    farol_pictureDepth: this.depth,
    farol_reuse: this.reuse,
    farol_shades: this.shades,
    farol_frameSize: this.size,
  };
  private readonly lit = edgeTwin(forwardTwins('lightLoopAll')('final').whole, this.uniforms);
  private readonly unlit = edgeTwin(plainWhole, this.uniforms);
  private target: WebGLRenderTarget | null = null;
  private readonly background = new FullscreenPass({
    program: 'edgeBackground',
    fragment: 'edgeBackground',
    shared: ['farol_frameSize'],
    microShaders: { edgeColor, edgeBackground },
    uniforms: { farol_picture: this.picture, farol_pictureDepth: this.depth, farol_farthest: { value: 1 } },
  });
  private readonly resolve = new FullscreenPass({
    program: 'edgeResolve',
    fragment: 'edgeResolve',
    microShaders: { edgeResolve },
    uniforms: {
      farol_picture: this.picture,
      farol_samples: { value: null as Texture | null },
      farol_whole: this.whole,
    },
    target: { type: HalfFloatType, minFilter: LinearFilter, magFilter: LinearFilter },
  });
  private shared: Picture | null = null;

  get bytes(): number {
    const own = this.target === null ? 0 : targetBytes(this.target);
    return own + this.resolve.bytes + (this.shared?.bytes ?? 0);
  }

  begin(frame: Frame): void {
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
  }

  end(frame: Frame): void {
    const picture = this.shared!;
    const { background, resolve } = this;
    const target = this.targetLike(picture.target);
    this.picture.value = picture.texture;
    this.size.value.set(frame.width, frame.height);
    this.depth.value = picture.target.depthTexture;
    background.uniforms.farol_farthest.value = isDepthReversed(frame.webgl) ? 0 : 1;
    resolve.uniforms.farol_samples.value = target.texture;
    this.setReuse(frame);
    frame.bind(target);
    frame.clear(0, true);
    background.draw(frame);
    for (const item of frame.queue.opaque) this.draw(frame, item);
    average(frame, target);
    picture.texture = resolve.drawToOwn(frame, frame.width, frame.height).texture;
    picture.end(frame);
  }

  dispose(): void {
    this.target?.dispose();
    this.target = null;
    this.background.dispose();
    this.resolve.dispose();
    this.shared?.dispose();
  }

  /**
   * Sets the uniforms for a frame: edges take a nearby pixel's colour where shading would lack transparent objects, decals or
   * effects, or cost too many lights.
   */
  private setReuse(frame: Frame): void {
    const { queue, lights } = frame;
    let laidOver = false;
    this.whole.value = queue.transmissive.length === 0;
    for (const { material } of queue.transparent) {
      if (material.depthWrite) this.whole.value = false;
      else laidOver = true;
    }
    const { resources, gbufferExtras } = frame;
    const changed = gbufferExtras.length > 0 || resources.find('decals') !== undefined;
    this.reuse.value = laidOver || changed || lights.total > this.shadedLights;
    this.shades.value = lights.total <= this.mostLights;
  }

  private draw(frame: Frame, item: RenderItem): void {
    const { depthTest, depthFunc, depthWrite, colorWrite, stencilWrite } = item.material;
    const plain = depthTest && depthFunc === LessEqualDepth && colorWrite && !stencilWrite;
    if (plain && hasMotionTwin(item)) frame.drawTwin(item, item.shading === 'lit' ? this.lit : this.unlit);
    else if (depthWrite || stencilWrite) this.whole.value = false;
  }

  /** Returns a multisampled target with the size and colour space of the picture. */
  private targetLike(picture: WebGLRenderTarget): WebGLRenderTarget {
    const { width, height, texture } = picture;
    if (this.target?.texture.colorSpace !== texture.colorSpace) {
      this.target?.dispose();
      this.target = new WebGLRenderTarget(width, height, {
        type: HalfFloatType,
        colorSpace: texture.colorSpace as '',
        samples: SAMPLES,
        minFilter: NearestFilter,
        magFilter: NearestFilter,
      });
      setDrawnAsCanvas(this.target, isDrawnAsCanvas(picture));
    }
    const target = this.target!;
    fitTargetTo(target, picture);
    return target;
  }
}

/** Resolves a multisampled target into its texture. */
function average({ gl, webgl }: Frame, target: WebGLRenderTarget): void {
  const { width, height } = target;
  bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, multisampledFramebufferHandle(webgl, target)!);
  bindFramebuffer(webgl, gl.DRAW_FRAMEBUFFER, framebufferHandle(webgl, target)!);
  gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, null);
}
