import {
  DepthTexture,
  DoubleSide,
  FloatType,
  LessEqualDepth,
  type MeshStandardMaterial,
  NearestFilter,
  RGBAFormat,
  RGFormat,
  Vector4,
  WebGLRenderTarget,
} from 'three';
import { fitTarget } from '../../gpu/fitTarget';
import { targetBytes } from '../../gpu/targetBytes';
import * as chunks from './chunks';
import type { ThinGBuffer } from '../../frame/ThinGBuffer';
import type { Frame } from '../../frame/Frame';
import { thinGBufferLayout } from './thinGBufferLayout';
import type { SharpLights } from '../../gbuffer/exceedsGBuffer';
import { hasAreaLights } from './hasAreaLights';
import { isLightBufferMaterial } from './isLightBufferMaterial';
import { resetObject, setObject } from './objectAttribute';
import { thinGBufferTwins, type ThinGBufferTwins } from './thinGBufferTwins';
import type { RenderItem } from '../../frame/RenderItem';
import { drawLayers } from './drawLayers';
import { gridFit, gridTexels } from './gridFit';
import { objectNumber } from './objectNumbers';
import type { Pass } from '../../frame/Pass';

/** Size and contents of the thin G-buffer. */
export interface ThinGBufferOptions {
  /** Whether the buffers' sides are `Frame.inferredScale` times the picture's; else equal to them. */
  readonly scaled: boolean;
  /** Whether transparent objects are drawn into the buffers too, each layer into one texel of each 2 × 2. */
  readonly stipple: boolean;
}

/**
 * Draws the surfaces that the light buffer can light, with only the values that lighting needs: normal, specular lobe, depth and
 * object number.
 * @see Engel 2009, The Light Pre-Pass Renderer; Kircher and Lawrance 2009, Inferred Lighting; thesis 2.2.3.3.2
 */
export class ThinGBufferPass implements Pass, ThinGBuffer {
  readonly name = 'thin g-buffer';
  readonly reads = [] as const;
  readonly writes = ['thin-gbuffer', 'scene-depth'] as const;
  readonly microShaders = { ...chunks };
  readonly fit = new Vector4(1, 1, 0, 0);
  readonly items: RenderItem[] = [];
  private made: WebGLRenderTarget | null = null;
  private knowsAreas = false;
  private lights?: SharpLights;
  private readonly scaleUniform = { value: 1 };
  private readonly twins: ThinGBufferTwins;

  constructor(private readonly options: ThinGBufferOptions) {
    this.twins = thinGBufferTwins(this.scaleUniform, { value: this.fit });
  }

  get bytes(): number {
    return this.made === null ? 0 : targetBytes(this.made);
  }

  /** Target of the thin G-buffer; made by `render`. */
  get target(): WebGLRenderTarget {
    return this.made!;
  }

  get scale(): number {
    return this.scaleUniform.value;
  }

  render(frame: Frame): void {
    this.prepareTarget(frame);
    this.knowsAreas = hasAreaLights(frame);
    this.lights = frame.lights;
    const { items } = this;
    items.length = 0;
    try {
      for (const item of frame.beginOrder()) {
        if (item.route !== 'split' || item.layered || !this.isLit(item)) continue;
        setObject(frame.gl, objectNumber(items.length), 0);
        frame.drawTwin(item, this.twins.opaque);
        items.push(item);
      }
      frame.queue.endOrder();
      if (this.options.stipple) this.drawTransparent(frame);
    } finally {
      resetObject(frame.gl);
    }
    frame.resources.put('thin-gbuffer', this);
    frame.resources.put('scene-depth', this.target.depthTexture!);
  }

  isStippled(item: RenderItem): boolean {
    const { material } = item;
    return (
      this.options.stipple &&
      item.shading === 'lit' &&
      !item.ownShader &&
      !item.layered &&
      material.depthTest &&
      material.depthFunc === LessEqualDepth &&
      this.isLit(item)
    );
  }

  /** Whether the light buffer lights an item's material. */
  private isLit({ material }: RenderItem): boolean {
    return isLightBufferMaterial(material, this.knowsAreas, this.lights);
  }

  dispose(): void {
    this.made?.depthTexture?.dispose();
    this.made?.dispose();
    this.made = null;
    this.items.length = 0;
  }

  private prepareTarget(frame: Frame): void {
    const scale = this.options.scaled ? frame.inferredScale : 1;
    const width = gridTexels(frame.width, scale);
    const height = gridTexels(frame.height, scale);
    this.scaleUniform.value = scale;
    gridFit(frame.width, frame.height, scale, this.fit);
    // attachments for distances or normals are kept once made: the next camera may need them again
    const before = this.made?.textures[1]?.format;
    const normals = before === RGBAFormat || needsVertexNormals(frame);
    const format = normals ? RGBAFormat : frame.storesDistance ? RGFormat : undefined;
    if (format !== undefined && format !== before) this.dispose();
    const target = (this.made ??= makeTarget(format));
    fitTarget(target, width, height);
    frame.bind(target);
    frame.clear(1, true);
  }

  private drawTransparent(frame: Frame): void {
    let layer = 0;
    for (const item of frame.queue.transparent) {
      if (this.isStippled(item)) layer = drawLayers(frame, item, this.twins.stippled, this.items.length, layer);
    }
  }
}

/** Whether shadow look-ups need vertex normals that differ from the shaded normals (normal bias with normal maps and the like). */
function needsVertexNormals({ lights, queue }: Frame): boolean {
  return lights.hasNormalBias && queue.opaque.some(shadesOtherNormals);
}

function shadesOtherNormals({ material }: RenderItem): boolean {
  const { normalMap, bumpMap, side } = material as MeshStandardMaterial;
  return Boolean(normalMap || bumpMap) || side === DoubleSide;
}

/** @param second - format of a second attachment: RG for distances (storedDistance.glsl), RGBA for distances and vertex normals */
function makeTarget(second?: typeof RGFormat | typeof RGBAFormat): WebGLRenderTarget {
  const target = new WebGLRenderTarget(1, 1, {
    count: second === undefined ? 1 : 2,
    format: thinGBufferLayout.format,
    type: thinGBufferLayout.type,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthTexture: new DepthTexture(1, 1, FloatType),
  });
  if (second !== undefined) target.textures[1].format = second;
  return target;
}
