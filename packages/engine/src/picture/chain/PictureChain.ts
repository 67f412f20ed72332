// an optional peer dependency: when it is absent, bundlers fail on named imports, but not on a namespace
import * as postprocessing from 'postprocessing';
import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  AlwaysDepth,
  type Camera,
  CineonToneMapping,
  type Data3DTexture,
  DepthTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearToneMapping,
  NeutralToneMapping,
  NoToneMapping,
  type PerspectiveCamera,
  ReinhardToneMapping,
  type Texture,
  type ToneMapping,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { Scene } from '../../core/Scene';
import type { PictureLook } from '../PictureLook';
import { AutomaticExposureEffect } from './AutomaticExposureEffect';
import { makeLookupTable } from './makeLookupTable';
import { DepthEffect, WhiteBalanceEffect } from './ownEffects';
import { whiteBalance } from './whiteBalance';

const modes: Partial<Record<ToneMapping, postprocessing.ToneMappingMode>> = {
  [LinearToneMapping]: postprocessing.ToneMappingMode.LINEAR,
  [ReinhardToneMapping]: postprocessing.ToneMappingMode.REINHARD,
  [CineonToneMapping]: postprocessing.ToneMappingMode.CINEON,
  [ACESFilmicToneMapping]: postprocessing.ToneMappingMode.ACES_FILMIC,
  [AgXToneMapping]: postprocessing.ToneMappingMode.AGX,
  [NeutralToneMapping]: postprocessing.ToneMappingMode.NEUTRAL,
};

/** Bit flags of enabled effects. */
const BLOOM = 1;
const FOCUS = 2;
const GRADING = 4;
const TABLE = 8;
const VIGNETTE = 16;
const TONES = 32;
const EXPOSURE = 64;

/**
 * Post-processes a picture of linear light with pmndrs' postprocessing: depth of field, bloom, white balance, automatic
 * exposure, tone mapping, contrast, saturation, colour table, vignette; the enabled ones in this order. Switching one
 * compiles new programs, changing a number does not.
 */
export class PictureChain {
  /** Whether post-processing besides tone mapping is drawn. */
  showsEffects = true;
  private target: WebGLRenderTarget | null = null;
  /** Target with the result of depth of field, to which bloom is then applied. */
  private focused: WebGLRenderTarget | null = null;
  private on = -1;
  private passes: postprocessing.EffectPass[] = [];
  private camera: Camera | null = null;
  private near = 0;
  private far = 0;
  private table: Data3DTexture | null = null;
  private tableOf: Texture | null = null;
  private waitsFor = '';
  private readonly focus: postprocessing.DepthOfFieldEffect;
  private readonly bloom: postprocessing.BloomEffect;
  private readonly balance = new WhiteBalanceEffect();
  private readonly tones = new postprocessing.ToneMappingEffect({ mode: postprocessing.ToneMappingMode.LINEAR });
  private readonly exposure = new AutomaticExposureEffect();
  private readonly contrast = new postprocessing.BrightnessContrastEffect();
  private readonly saturation = new postprocessing.HueSaturationEffect();
  private lookup: postprocessing.LUT3DEffect | null = null;
  private readonly vignette = new postprocessing.VignetteEffect();
  private readonly depth = new DepthEffect();

  /** Whether a device can render to float textures. */
  static isPossible({ extensions }: WebGLRenderer): boolean {
    return extensions.has('EXT_color_buffer_float') || extensions.has('EXT_color_buffer_half_float');
  }

  /** @param redraw - called when an awaited colour lookup table is loaded */
  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly redraw: () => void,
  ) {
    this.focus = new postprocessing.DepthOfFieldEffect(undefined, { resolutionScale: 0.5 });
    this.bloom = new postprocessing.BloomEffect({
      blendFunction: postprocessing.BlendFunction.ADD,
      mipmapBlur: true,
      luminanceSmoothing: 0.1,
    });
  }

  /**
   * Render target for the scene: linear light, with a depth texture.
   * @param width - pixels
   * @param height - pixels
   * @param samples - samples per pixel; 0 for no multisampling
   */
  begin(width: number, height: number, samples: number): WebGLRenderTarget {
    if (this.target !== null && this.target.samples !== samples) this.freeTarget();
    if (this.target === null) {
      this.target = new WebGLRenderTarget(width, height, {
        type: HalfFloatType,
        minFilter: LinearFilter,
        magFilter: LinearFilter,
        samples,
        depthTexture: new DepthTexture(width, height, FloatType),
      });
      this.target.texture.name = 'Picture';
      this.on = -1;
    }
    const { target } = this;
    if (target.width !== width || target.height !== height) {
      target.setSize(width, height);
      this.focused?.setSize(width, height);
      for (const pass of this.passes) pass.setSize(width, height);
    }
    return target;
  }

  /**
   * Post-processes the target of `begin`.
   * @param to - target, already bound; null for the canvas. Receives the scene's depth too
   */
  draw(scene: Scene, look: PictureLook, camera: Camera, to: WebGLRenderTarget | null): void {
    const { webgl } = this;
    this.setUp(scene, look, camera);
    const { autoClear, toneMappingExposure } = webgl;
    webgl.autoClear = false;
    webgl.toneMappingExposure = look.exposure;
    try {
      let from = this.target!;
      for (let i = 0; i < this.passes.length; i++) {
        const next = i === this.passes.length - 1 ? to : this.focused;
        this.passes[i].render(webgl, from, next as WebGLRenderTarget, 0);
        if (next !== null) from = next;
      }
    } finally {
      webgl.autoClear = autoClear;
      webgl.toneMappingExposure = toneMappingExposure;
    }
  }

  dispose(): void {
    this.freePasses();
    this.freeTarget();
    for (const effect of this.all) effect.dispose();
    this.table?.dispose();
    this.table = this.tableOf = null;
  }

  private get all(): postprocessing.Effect[] {
    const { focus, bloom, balance, exposure, tones, contrast, saturation, vignette, depth, lookup } = this;
    return [focus, bloom, balance, exposure, tones, contrast, saturation, vignette, depth, ...(lookup ? [lookup] : [])];
  }

  private setUp(scene: Scene, look: PictureLook, camera: Camera): void {
    const { settings } = scene;
    const { showsEffects } = this;
    const grading = showsEffects && settings.grading;
    let on = look.toneMapping === NoToneMapping ? 0 : TONES;
    if (look.automatic) on |= EXPOSURE;
    if (showsEffects && settings.bloom) on |= BLOOM;
    if (showsEffects && look.depthOfField) on |= FOCUS;
    if (showsEffects && settings.vignette) on |= VIGNETTE;
    if (grading) on |= GRADING;
    if (grading && settings.lut !== null && this.takeTable(scene, settings.lut)) on |= TABLE;
    this.tones.mode = modes[look.toneMapping] ?? postprocessing.ToneMappingMode.LINEAR;
    if (on !== this.on) this.make(on, camera);
    this.setCamera(camera);
    if (look.automatic) this.exposure.follow(look.automatic, scene, camera);
    const { bloom, focus, vignette, lookup } = this;
    bloom.intensity = settings.bloomIntensity;
    bloom.luminanceMaterial.threshold = settings.bloomThreshold;
    (bloom as postprocessing.BloomEffect & { mipmapBlurPass: { radius: number } }).mipmapBlurPass.radius =
      settings.bloomRadius;
    focus.cocMaterial.focusDistance = look.focusDistance;
    focus.cocMaterial.focusRange = look.focusRange;
    if (focus.bokehScale !== look.focusBlur) focus.bokehScale = look.focusBlur;
    this.contrast.contrast = settings.contrast;
    this.saturation.saturation = settings.saturation;
    if (grading) whiteBalance(settings.temperature, settings.tint, this.balance.balance);
    if (lookup) lookup.blendMode.opacity.value = settings.lutStrength;
    vignette.darkness = settings.vignetteDarkness;
    vignette.offset = settings.vignetteSize;
    this.depth.texture = this.target!.depthTexture;
  }

  /** Makes the post-processing passes of the enabled effects. */
  private make(on: number, camera: Camera): void {
    this.freePasses();
    this.on = on;
    const { webgl } = this;
    const target = this.target!;
    const { width, height } = target;
    const light: postprocessing.Effect[] = [];
    if (on & BLOOM) light.push(this.bloom);
    if (on & GRADING) light.push(this.balance);
    if (on & EXPOSURE) light.push(this.exposure);
    if (on & TONES) light.push(this.tones);
    if (on & GRADING) light.push(this.contrast, this.saturation);
    if (on & TABLE) light.push(this.lookup!);
    if (on & VIGNETTE) light.push(this.vignette);
    light.push(this.depth);
    if (on & FOCUS) this.passes.push(new postprocessing.EffectPass(camera, this.focus));
    this.passes.push(new postprocessing.EffectPass(camera, ...light));
    for (const pass of this.passes) {
      pass.initialize(webgl, false, HalfFloatType);
      pass.setDepthTexture(target.depthTexture!);
      pass.setSize(width, height);
    }
    const { fullscreenMaterial } = this.passes.at(-1)!;
    fullscreenMaterial.depthTest = fullscreenMaterial.depthWrite = true;
    fullscreenMaterial.depthFunc = AlwaysDepth;
    if (this.passes.length > 1) {
      this.focused ??= new WebGLRenderTarget(width, height, { type: HalfFloatType, depthBuffer: false });
      this.focused.setSize(width, height);
    }
    this.camera = null;
  }

  /** Sets the camera of the passes, only on a change, since that recompiles their programs. */
  private setCamera(camera: Camera): void {
    const { near, far } = camera as PerspectiveCamera;
    if (camera === this.camera && near === this.near && far === this.far) return;
    this.camera = camera;
    this.near = near;
    this.far = far;
    for (const pass of this.passes) pass.mainCamera = camera;
  }

  /** Prepares the colour lookup table. @returns whether it is loaded */
  private takeTable({ assets }: Scene, name: string): boolean {
    if (!assets.isReady('texture', name)) {
      if (name !== this.waitsFor) assets.whenReady('texture', name, this.redraw);
      this.waitsFor = name;
      return false;
    }
    const texture = assets.texture(name);
    if (texture === this.tableOf) return this.table !== null;
    this.table?.dispose();
    this.tableOf = texture;
    this.table = makeLookupTable(texture);
    if (this.table === null) return false;
    if (this.lookup === null)
      this.lookup = new postprocessing.LUT3DEffect(this.table, { blendFunction: postprocessing.BlendFunction.NORMAL });
    else this.lookup.lut = this.table;
    return true;
  }

  /** Disposes of the passes but not of their effects, which are detached first. */
  private freePasses(): void {
    for (const pass of this.passes) {
      (pass as unknown as { setEffects(effects: postprocessing.Effect[]): void }).setEffects([]);
      pass.dispose();
    }
    this.passes = [];
    this.on = -1;
  }

  private freeTarget(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.focused?.dispose();
    this.target = this.focused = null;
  }
}
