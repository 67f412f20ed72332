import { type FarolEffect, FarolRenderer, type TechniqueName } from '@farol/renderer';
import { type EffectEntry, type EffectName, effects, loadEffects } from '@farol/renderer/effects';
import * as THREE from 'three';
import type { TestScene } from '../materialScene';
import { random } from '../random';
import { type ActName, acts, THROWN } from './acts';
import { GpuObjects } from './GpuObjects';
import { casters, disposeScene, soakScenes } from './soakScenes';

/** Acts of a round, and their result. */
export interface Round {
  readonly acts: readonly string[];
  /** Largest difference of a channel from a fresh renderer's picture, of 255. */
  readonly difference: number;
  /** How many of the channels differ by more than 1. */
  readonly share: number;
  readonly technique: string;
  /** Errors that nobody threw on purpose, and GL errors. */
  readonly problems: readonly string[];
}

const SIZE = [160, 96] as const;

const entries: Readonly<Record<EffectName, EffectEntry>> = effects;
const effectClasses = await loadEffects();

/** Effects that stand alone. What joins frames, such as fog, begins anew before pictures are compared. */
const alone = (Object.keys(effects) as EffectName[]).filter((name) => entries[name].group === undefined);

/** Techniques that ambient occlusion works with. */
const knowsDepth: ReadonlySet<string> = new Set([
  'deferred',
  'tiled-deferred',
  'clustered-deferred',
  'light-prepass',
  'forward-plus',
]);

/** One renderer that lives through everything, and one beside it that knows nothing of that, on which fresh ones are made. */
export class Soak {
  readonly random: () => number;
  readonly webgl: THREE.WebGLRenderer;
  readonly farol: FarolRenderer;
  readonly objects: GpuObjects;
  /** Rounds so far. */
  count = 0;
  /** Scenes that were opened, by name. */
  readonly scenes = new Map<string, TestScene>();
  scene!: THREE.Scene;
  camera!: THREE.Camera;
  /** Lights that the soak has put into the scene. */
  added: THREE.Light[] = [];

  /** Everything that can be done. */
  static readonly kinds = Object.keys(acts) as ActName[];

  private readonly calm = new THREE.WebGLRenderer({ antialias: false });
  private readonly made = new Map<EffectName, FarolEffect>();
  /** Functions that dispose the last fresh renderer, by technique. */
  private readonly last = new Map<string, () => void>();
  /**
   * Objects on the GPU that are three's own, and kept: empty textures, one of depths among them, scratch framebuffers, and the
   * table of the DFG term.
   */
  private readonly first: Record<string, number>;
  private chosen: EffectName[] = [];
  private problems: string[] = [];
  private width: number = SIZE[0];
  private height: number = SIZE[1];

  /** @param kinds - acts that may be done */
  constructor(
    seed: number,
    private readonly kinds: readonly ActName[] = Object.keys(acts) as ActName[],
  ) {
    this.random = random(seed);
    const canvas = document.createElement('canvas');
    // before three makes its own
    this.objects = new GpuObjects(canvas);
    this.webgl = new THREE.WebGLRenderer({ canvas, antialias: false });
    for (const webgl of [this.webgl, this.calm]) {
      webgl.shadowMap.enabled = true;
      webgl.setSize(...SIZE, false);
    }
    drawLit(this.webgl);
    this.first = this.objects.table;
    this.farol = new FarolRenderer(this.webgl, { shadowAtlasSize: 1024 });
    this.openScene('edges');
  }

  set shadowType(type: THREE.ShadowMapType) {
    for (const webgl of [this.webgl, this.calm]) webgl.shadowMap.type = type;
  }

  get shadowType(): THREE.ShadowMapType {
    return this.webgl.shadowMap.type;
  }

  /** Does some things, draws after each, and compares the last picture with that of a fresh renderer. */
  async round(): Promise<Round> {
    this.count++;
    this.problems = [];
    const done: string[] = [];
    for (let i = 2 + Math.floor(this.random() * 5); i > 0; i--) {
      const name = this.kinds[Math.floor(this.random() * this.kinds.length)];
      const what = await acts[name](this);
      done.push(what === '' ? name : `${name} (${what})`);
      this.draw();
    }
    const fixed = Object.keys(this.farol.techniques).filter((name) => name !== 'auto') as TechniqueName[];
    if (this.farol.technique === 'auto') this.farol.technique = fixed[Math.floor(this.random() * fixed.length)];
    this.applyEffects();
    if (this.chosen.includes('taa')) this.setEffects(this.chosen.filter((name) => name !== 'taa'));
    return { acts: done, technique: this.farol.technique, ...this.compare(), problems: this.problems };
  }

  /** Brings all back to where it began, without the fresh renderers, and counts the objects on the GPU. */
  rest(): { objects: number; table: Record<string, number> } {
    const { farol } = this;
    this.disposeFresh();
    farol.technique = 'forward';
    farol.view = 'final';
    farol.shadowCascades = 1;
    farol.lightLayers = false;
    this.shadowType = THREE.PCFShadowMap;
    this.setEffects([]);
    this.resize(...SIZE);
    for (const { scene } of this.scenes.values()) this.close(scene);
    this.scenes.clear();
    this.openScene('edges');
    for (let i = 0; i < 3; i++) this.draw();
    this.freeLostContexts();
    return { objects: this.objects.count, table: this.objects.table };
  }

  /** Frees everything. @returns what is left on the GPU of each kind, less what was there before the first frame */
  end(): Record<string, number> {
    this.disposeFresh();
    for (const { scene } of this.scenes.values()) this.close(scene);
    for (const effect of this.made.values()) effect.dispose();
    this.farol.dispose();
    drawLit(this.webgl);
    const left = Object.entries(this.objects.table).map(([kind, count]) => [kind, count - (this.first[kind] ?? 0)]);
    return Object.fromEntries(left.filter(([, count]) => count !== 0)) as Record<string, number>;
  }

  /**
   * Frees what three itself keeps of lost contexts: its look-up table of reflectance and its empty map of depths, one texture
   * each for all renderers, hold the state of each context that ever sent them to a device until they are disposed. They are
   * sent once more at once.
   */
  private freeLostContexts(): void {
    const kept = new Set([this.webgl, this.calm].flatMap(drawLit));
    this.objects.forgiveLost(() => {
      for (const texture of kept) texture.dispose();
    });
    for (const webgl of [this.webgl, this.calm]) drawLit(webgl);
  }

  private disposeFresh(): void {
    for (const dispose of this.last.values()) dispose();
    this.last.clear();
  }

  /** Draws a frame; what it throws is a problem, unless the soak had it thrown. */
  draw(): void {
    try {
      this.farol.render(this.scene, this.camera);
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      if (text !== THROWN) this.problems.push(text);
    }
  }

  /** Shows a scene. @param anew - whether one that was there before is disposed, and made once more */
  openScene(name: string, anew = false): string {
    for (const light of this.added.splice(0)) {
      light.removeFromParent();
      light.dispose();
    }
    const before = this.scenes.get(name);
    if (before && anew) this.close(before.scene);
    if (!before || anew) {
      const made = soakScenes[name](...SIZE);
      for (const { shadow } of casters(made.scene)) {
        shadow.mapSize.set(64, 64);
        // shadow maps stay at 24 bits after the first light that needs them: with this bias each light does
        shadow.bias = -0.0002;
      }
      this.scenes.set(name, made);
    }
    const { scene, camera } = this.scenes.get(name)!;
    this.scene = scene;
    this.camera = camera;
    this.resize(this.width, this.height);
    this.applyEffects();
    return anew ? `${name} anew` : name;
  }

  resize(width: number, height: number): string {
    this.width = width;
    this.height = height;
    for (const webgl of [this.webgl, this.calm]) webgl.setSize(width, height, false);
    if (this.camera instanceof THREE.PerspectiveCamera) {
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
    return `${width} × ${height}`;
  }

  chooseEffects(): string {
    const names = alone.filter(() => this.random() < 0.3);
    const smoothing = (['smaa', 'edges', 'taa', null, null] as const)[Math.floor(this.random() * 5)];
    this.setEffects(smoothing ? [...names, smoothing] : names);
    this.draw();
    return this.chosen.join(', ') || 'none';
  }

  /** Loses the context, draws as a page does that knows nothing of it, and has it restored. */
  async loseContext(): Promise<string> {
    const { domElement: canvas } = this.webgl;
    const extension = this.webgl.getContext().getExtension('WEBGL_lose_context');
    if (!extension) throw new Error('The context cannot be lost: it is.');
    const event = (name: string) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
    const lost = event('webglcontextlost');
    extension.loseContext();
    if (this.random() < 0.5) this.draw();
    await lost;
    this.draw();
    const restored = event('webglcontextrestored');
    // in a later task: the browser restores no context in the task that tells of its loss
    setTimeout(() => extension.restoreContext());
    await restored;
    return '';
  }

  /** As in stock three, what was drawn before a loss is deleted once more, in a context that knows nothing of it. */
  private close(scene: THREE.Scene): void {
    this.objects.forgiveLost(() => disposeScene(scene));
  }

  private setEffects(names: readonly EffectName[]): void {
    this.chosen = [...names];
    this.applyEffects();
  }

  /** Uses the chosen effects, less those that say that the technique or the camera has no use for them. */
  applyEffects(): void {
    const { technique } = this.farol;
    const isFlat = !(this.camera instanceof THREE.PerspectiveCamera);
    this.chosen = this.chosen
      .filter((name) => name !== 'ambient-occlusion' || knowsDepth.has(technique))
      .filter((name) => name !== 'volumetric-fog' || !isFlat);
    this.farol.effects = this.chosen.map((name) => {
      let effect = this.made.get(name);
      if (!effect) this.made.set(name, (effect = new effectClasses[name]()));
      return effect;
    });
  }

  private compare(): { difference: number; share: number } {
    const { farol, scene, camera, calm } = this;
    const fresh = new FarolRenderer(calm, { shadowAtlasSize: 1024, technique: farol.technique });
    fresh.shadowCascades = farol.shadowCascades;
    fresh.lightLayers = farol.lightLayers;
    const own = this.chosen.map((name) => new effectClasses[name]());
    fresh.effects = own;
    // effects of both renderers start anew: they average as many frames, with the same noise
    for (const effect of [...farol.effects, ...own]) {
      effect.reset?.();
      if ('time' in effect) effect.time = 0;
    }
    // effects and shadow maps may need a frame before theirs is whole
    for (let i = 0; i < 2; i++) {
      this.draw();
      fresh.render(scene, camera);
    }
    this.draw();
    const seen = this.read(this.webgl);
    fresh.render(scene, camera);
    const right = this.read(calm);
    // the one before of this technique goes now: renderers that live beside one another must not disturb one another
    this.last.get(farol.technique)?.();
    this.last.set(farol.technique, () => {
      for (const effect of own) effect.dispose();
      fresh.dispose();
    });
    let difference = 0;
    let off = 0;
    for (let i = 0; i < seen.length; i++) {
      const apart = Math.abs(seen[i] - right[i]);
      if (apart > difference) difference = apart;
      if (apart > 1) off++;
    }
    return { difference, share: off / seen.length };
  }

  private read(webgl: THREE.WebGLRenderer): Uint8Array {
    const gl = webgl.getContext();
    const data = new Uint8Array(this.width * this.height * 4);
    gl.readPixels(0, 0, this.width, this.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    for (let error = gl.getError(); error !== 0; error = gl.getError()) this.problems.push(`GL error ${error}`);
    return data;
  }
}

/**
 * Draws by stock three something lit, and a look-up of a depth that is not there, so that three makes the textures it keeps
 * for good; frees the rest.
 * @returns textures that three has one of for all renderers: its look-up table of reflectance, and the empty map of depths
 */
function drawLit(webgl: THREE.WebGLRenderer): THREE.Texture[] {
  const geometry = new THREE.PlaneGeometry();
  const comparing = new THREE.ShaderMaterial({
    uniforms: { depths: { value: null } },
    fragmentShader:
      'uniform highp sampler2DShadow depths; void main() { gl_FragColor = vec4(texture(depths, vec3(0.5))); }',
  });
  const lit = new THREE.MeshStandardMaterial();
  const scene = new THREE.Scene().add(
    new THREE.Mesh(geometry, lit),
    new THREE.Mesh(geometry, comparing),
    new THREE.PointLight(),
  );
  const camera = new THREE.PerspectiveCamera();
  camera.position.z = 2;
  webgl.render(scene, camera);
  const { uniforms } = webgl.properties.get(lit) as { uniforms: Record<string, THREE.IUniform<THREE.Texture>> };
  const kept = [uniforms.dfgLUT.value, emptyDepths(webgl, comparing)];
  disposeScene(scene);
  return kept;
}

/** A uniform of a program of three's, which asks for a texture unit and binds to it what its value is. */
interface SamplerUniform {
  readonly cache: readonly number[];
  setValue(gl: unknown, value: null, textures: object): void;
}

/** Texture that three binds where a material's `uniform sampler2DShadow depths` has none. */
function emptyDepths(webgl: THREE.WebGLRenderer, material: THREE.Material): THREE.Texture {
  const { currentProgram } = webgl.properties.get(material) as {
    currentProgram: { getUniforms(): { map: { depths: SamplerUniform } } };
  };
  const { depths } = currentProgram.getUniforms().map;
  const bound: THREE.Texture[] = [];
  depths.setValue(webgl.getContext(), null, {
    allocateTextureUnit: () => depths.cache[0],
    setTexture2D: (texture: THREE.Texture) => bound.push(texture),
  });
  return bound[0];
}
