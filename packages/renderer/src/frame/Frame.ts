import {
  type Camera,
  type Color,
  DoubleSide,
  type BufferGeometry,
  type Material,
  Mesh,
  type Object3D,
  type RawShaderMaterial,
  type Scene,
  type ShaderMaterial,
  UnsignedShortType,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import type { AtlasTiles } from './AtlasTiles';
import type { View } from './views';
import type { Fills } from './Fills';
import type { GBuffer } from '../gbuffer/GBuffer';
import { warnOfNaN } from './warnOfNaN';
import { farthestTold, isPlainProjection, needsStoredDistance } from '../gbuffer/depthLimits';
import { gbufferLayout, type GBufferAttachment } from '../gbuffer/gbufferLayout';
import { isWeakDevice, type Quality } from '../gpu/isWeakDevice';
import type { FarolEffect } from './FarolEffect';
import type { FieldDraws } from './FieldDraws';
import { FrameTarget } from './FrameTarget';
import type { LightTable } from '../lighting/LightTable';
import type { ReactiveMask } from './ReactiveMask';
import { depthTwin, hasDepthTwin } from '../materials/depthTwin';
import type { ForwardTwins } from '../materials/forwardTwin';
import { setLayers } from '../materials/layersAttribute';
import { plainBack, plainFront, plainWhole } from '../materials/plainTwins';
import { followHostUniforms } from '../materials/hostUniforms';
import { surfacesOf } from '../materials/surfacesOf';
import type { TwinCache } from '../materials/TwinCache';
import type { TwinKind } from '../materials/TwinKind';
import type { MicroShaderRegistry } from '../microshaders';
import { logarithmicFar } from '../gpu/unprojectUniforms';
import { CallbackWatch, isEmptyCallback } from './hostCallbacks';
import type { RenderItem } from './RenderItem';
import type { GeometryGroup } from '../three/RenderListItem';
import type { NodeDraws } from '../three/nodes/NodeDraws';
import { hasOwnShader, RenderQueue } from './RenderQueue';
import { ResourceTable } from './Resources';
import type { Session } from './Session';
import type { SharedUniforms } from './sharedUniforms';
import type { TwinAdapter } from './TwinAdapter';
import { directDraw, type DirectDraw } from '../three/directDraw';
import { isDepthReversed } from '../three/state';

type MaterialCallback = (
  r: WebGLRenderer,
  s: Scene,
  c: Camera,
  g: BufferGeometry,
  o: Object3D,
  p: GeometryGroup | null,
) => void;

/** Twins and draws whose code is late: each method returns null until its code is loaded, and fetches it. */
export interface LateDraws {
  /** Forward twins of materials with Gouraud shading. */
  gouraudTwins(view: View): ForwardTwins | null;
  /** Makes the draws of node materials by three. */
  makeNodes(): NodeDraws | null;
}

/** Compiles the programs of passes: a little in each `step`. */
export interface Preparation {
  readonly ready: boolean;
  step(effects: readonly FarolEffect[]): void;
}

/** Shadow maps, as passes and views use them; implemented by ShadowMaps. */
export interface TileShadows {
  /**
   * Finds the screen tiles that a light's shadow map leaves wholly lit, or wholly dark. Call once the light grid is written.
   * @param gbuffer - G-buffer of the frame
   */
  findTileShadows(frame: Frame, gbuffer: GBuffer): void;
  /** Lists the regions in use of the atlas of images and profiles, or of the atlas of shadow maps. */
  listTiles(images: boolean): AtlasTiles;
}

/**
 * A frame as passes and effects see it: scene, target, queue, lights, resources, and methods to draw. One object for each
 * FarolRenderer.
 */
export class Frame extends FrameTarget {
  readonly queue = new RenderQueue();
  /** Resources that the passes of this frame have written so far. */
  readonly resources = new ResourceTable();

  // ---- Set by `begin` ----

  scene!: Scene;
  /** The host's camera, or a stand-in set in `begin` by an effect with `FarolEffect.movesCamera`. */
  camera!: Camera;
  /** The host's camera, or the ArrayCamera that contains it: its layers select the lights and the shadow casters. */
  seenBy!: Camera;
  /** XR session, or other session of several pictures; null for none. */
  session: Session | null = null;
  view: View = 'final';
  /** Whether all passes support the camera's projection: see `isPlainProjection`. */
  hasPlainProjection = true;
  /** Whether the depth buffer is too coarse to rebuild positions from. */
  private isDepthCoarse = false;

  /** Whether fog scatters light, so that shadow maps are sampled away from surfaces; set in `begin` by an effect. */
  hasMedia = false;

  // ---- Set by `FrameLights.update` ----

  /** The lights of light fields; null if the frame has none. */
  fields: FieldDraws | null = null;
  /** Compiles programs for light lists at the ends of frames; null while there are none to compile. */
  preparation: Preparation | null = null;
  /** Visibility of shadows by screen tile; null while no light casts a shadow. */
  tileShadows: TileShadows | null = null;
  /** Number of shadow maps drawn in this frame. */
  shadowMapsDrawn = 0;

  // ---- Set by `SceneDraws`, from the effects of the frame and the pixels that three leaves uncleared ----

  /** Adapters that replace the twin kind of a draw, in order: each receives the kind that the previous one returned. */
  adapters: readonly TwinAdapter[] = [];
  /** Attachments of the G-buffer after those of `gbufferLayout`. */
  gbufferExtras: readonly GBufferAttachment[] = [];
  /** Whether all shaders of the frame can read its lights from uniforms, if they are few (fewLights.glsl). */
  readsFew = false;
  /** Pixels that the technique fills in place of three's clear; null where three has cleared the target. */
  fills: Fills | null = null;

  // ---- Set while the frame is drawn ----

  /** Receives draws whose pixels have no usable history; set in `begin` by TAA. */
  reactive: ReactiveMask<Frame> | null = null;
  /** Bytes that passes have uploaded in this frame; each pass adds its uploads. */
  uploadedBytes = 0;
  /** Bytes of a pixel of the frame's G-buffer, depth left out; 0 for none. */
  gbufferPixel = 0;
  /** Whether an item of a node material was not drawn, since its code is not loaded; set by `drawNodes`. */
  lacksNodes = false;

  /** Side of the lighting buffers of 'inferred', as a share of the picture's: above 0, at most 1. Set by FarolRenderer. */
  inferredScale = 1;
  /** Option `quality`. Set by FarolRenderer. */
  quality: Quality = 'auto';
  /** Whether the device is weak; null until the first frame that reads it, since a lost context gives no answer. */
  private isWeak: boolean | null = null;
  private nodes: NodeDraws | null = null;
  /** Draws one object with one material, inside three's `render`. */
  readonly draw: DirectDraw;
  private readonly callbacks: CallbackWatch;

  constructor(
    webgl: WebGLRenderer,
    readonly lights: LightTable,
    readonly twins: TwinCache,
    readonly uniforms: SharedUniforms,
    readonly microshaders: MicroShaderRegistry,
    private readonly late: LateDraws,
  ) {
    super(webgl);
    this.draw = directDraw(webgl);
    this.callbacks = new CallbackWatch(webgl);
  }

  override bindTarget(): void {
    // three has bound the target for this frame: with few lights no draw to other targets has come before
    if (this.readsFew && this.webgl.getRenderTarget() === this.target) return;
    super.bindTarget();
    this.uniforms.farol_targetOrigin.value.set(0, 0);
  }

  override bind(target: WebGLRenderTarget): void {
    super.bind(target);
    this.uniforms.farol_targetOrigin.value.set(this.viewport.x, this.viewport.y);
  }

  /** Location of an attachment of `gbufferExtras` in G-buffers, -1 where the device has no room for it. */
  locationOf(extra: GBufferAttachment): number {
    const index = this.gbufferExtras.indexOf(extra);
    return index < 0 ? -1 : gbufferLayout.length + index;
  }

  /** Whether the quality is 'lite': smaller G-buffers and shadow maps. */
  get isLite(): boolean {
    return this.quality === 'lite' || (this.quality === 'auto' && (this.isWeak ??= isWeakDevice(this.webgl)));
  }

  /** Whether surfaces store their distance, since depth is too coarse or shifted to compute positions from. */
  get storesDistance(): boolean {
    return this.isDepthCoarse || this.queue.farthest === -Infinity;
  }

  /**
   * Begins a frame with the host's current target and viewport.
   * @param seenBy - the camera, or the ArrayCamera that contains it
   */
  begin(scene: Object3D, camera: Camera, seenBy: Camera, view: View, session: Session | null): void {
    const { webgl } = this;
    this.scene = scene as Scene;
    this.camera = camera;
    this.seenBy = seenBy;
    this.view = view;
    this.uploadedBytes = this.gbufferPixel = 0;
    this.readsFew = false;
    this.session = session;
    this.reactive = null;
    this.hasMedia = false;
    this.resources.begin();
    this.nodes?.begin();
    this.lacksNodes = false;
    this.beginTarget();
    const { elements } = camera.projectionMatrix;
    this.hasPlainProjection = isPlainProjection(elements, 'isOrthographicCamera' in camera);
    const reversed = isDepthReversed(webgl);
    const logarithmic = logarithmicFar(camera, webgl);
    this.isDepthCoarse = needsStoredDistance(elements, reversed || logarithmic > 0);
    const coarse = this.target?.depthTexture?.type === UnsignedShortType;
    this.queue.watchFar(camera, farthestTold(elements, reversed, logarithmic, coarse));
    warnOfNaN(camera);
  }

  /** Whether the host's target has depth, and three clears it for this frame. */
  private get clearsDepth(): boolean {
    const { webgl, scene } = this;
    if (!this.hasDepth || !webgl.autoClearDepth) return false;
    return webgl.autoClear || (scene.background as Color | null)?.isColor === true;
  }

  /** Begins draws of opaque items, each once, to the host's target, as `RenderQueue.beginOrder`. */
  beginOrder(): readonly RenderItem[] {
    return this.clearsDepth ? this.queue.beginOrder() : this.queue.opaque;
  }

  /**
   * Whether later draws to a multisampled target need depth in each sample, for items that were drawn to other targets. False if
   * the target already has other depth.
   */
  get wantsSampleDepths(): boolean {
    const { webgl, queue, view } = this;
    if (this.samples === 0 || view !== 'final' || queue.early > 0 || webgl.capabilities.logarithmicDepthBuffer)
      return false;
    if (!this.clearsDepth) return false;
    return queue.transparent.length + queue.transmissive.length > 0 || queue.opaque.some(isLeft);
  }

  /** Draws the depth of items that were drawn to other targets into the samples of the target. */
  drawSampleDepths(): void {
    for (const item of this.queue.opaque) {
      if (item.drawn && item.route === 'split' && hasDepthTwin(item.material)) this.drawTwin(item, depthTwin);
    }
  }

  /** Twin kind to draw an item with, as replaced by the `adapters`. */
  private adapted(kind: TwinKind, item: RenderItem): TwinKind {
    const { adapters } = this;
    for (let i = 0; i < adapters.length; i++) kind = adapters[i].adapt(kind, item);
    return kind;
  }

  /** Draws an item with a twin of its material, if the material can have one. */
  drawTwin(item: RenderItem, kind: TwinKind): void {
    if (item.shading === 'nodes') return;
    if (item.ownShader) followHostUniforms(this.webgl, item.material);
    this.drawItem(item, this.twins.get(item.material, this.adapted(kind, item)));
  }

  /** Forward twins of materials with Gouraud shading; null until their code is loaded. */
  gouraudTwins(): ForwardTwins | null {
    return this.late.gouraudTwins(this.view);
  }

  /** Draws an item forward: a lit item by a twin of its material, any other with its own material. */
  drawForward(item: RenderItem, twins: ForwardTwins): void {
    const { material, shading } = item;
    const lit = shading === 'lit';
    if (shading === 'nodes') this.drawNodes(item);
    else if (shading === 'shadow-mask') this.drawTwin(item, this.queue.shadowMasks!.twin);
    else if (material.transparent && material.side === DoubleSide && !material.forceSinglePass) {
      this.drawTwin(item, lit ? twins.back : plainBack);
      this.drawTwin(item, lit ? twins.front : plainFront);
    } else if (lit) this.drawTwin(item, twins.whole);
    else if (surfacesOf(material) || this.adapted(plainWhole, item) !== plainWhole) this.drawTwin(item, plainWhole);
    else this.drawItem(item, material);
  }

  /** Lets three draw an item of a node material, unless it is drawn already. */
  drawNodes(item: RenderItem): void {
    if (item.drawn) return;
    this.nodes ??= this.late.makeNodes();
    if (this.nodes === null) this.lacksNodes = true;
    else this.nodes.draw(this, item);
  }

  /** Compiles the program of one of Farol's own meshes ahead, by an empty draw. */
  compileMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    const { drawRange } = mesh.geometry;
    const { count } = drawRange;
    drawRange.count = 0;
    try {
      this.drawMesh(mesh, material);
    } finally {
      // restored, since meshes of other renderers share this geometry
      drawRange.count = count;
    }
  }

  /** Draws one of Farol's own meshes; of a host's target with several textures, only to the first. */
  drawMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    const several = this.drawsToSeveral;
    if (several) this.setDrawBuffers(1);
    try {
      this.draw(this.camera, this.scene, mesh.geometry, material, mesh, null);
    } finally {
      if (several) this.setDrawBuffers(this.target!.textures.length);
    }
  }

  /** Draws an item with a material, and calls `onBeforeRender` and `onAfterRender` of object and host's material. */
  drawItem(item: RenderItem, material: Material): void {
    const { object, geometry, group } = item;
    const { webgl, scene, camera } = this;
    const source = item.material as ShaderMaterial;
    if (!isEmptyCallback(object.onBeforeRender)) this.callHost(item, 'onBeforeRender');
    if (this.queue.layers !== 0) setLayers(this.gl, object.layers.mask);
    object.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, object.matrixWorld);
    object.normalMatrix.getNormalMatrix(object.modelViewMatrix);
    (source.onBeforeRender as unknown as MaterialCallback)(webgl, scene, camera, geometry, object, group);
    // three's own shaders of lit materials write only the first texture
    const first = item.shading === 'lit' && this.drawsToSeveral && !hasOwnShader(source);
    if (first) this.setDrawBuffers(1);
    try {
      const { order, pivot } = this.queue;
      const draw = source.id < pivot ? order!.draw : this.draw;
      draw(camera, scene, geometry, material, object, group);
    } finally {
      if (first) this.setDrawBuffers(this.target!.textures.length);
    }
    if (source.uniformsNeedUpdate === true) source.uniformsNeedUpdate = false;
    if (!isEmptyCallback(object.onAfterRender)) this.callHost(item, 'onAfterRender');
  }

  private callHost({ object, geometry, material, group }: RenderItem, name: 'onBeforeRender' | 'onAfterRender'): void {
    const { webgl, scene, camera, callbacks } = this;
    callbacks.begin(object[name]);
    try {
      (object[name] as unknown as MaterialCallback)(webgl, scene, camera, geometry, material as never, group);
    } finally {
      callbacks.end();
    }
  }
}

const isLeft = (item: RenderItem): boolean => !item.drawn;
