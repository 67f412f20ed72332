import './frame.css';
import { FarolRenderer, type FarolOptions } from '@farol/renderer';
import {
  Color,
  PerspectiveCamera,
  type PointLight,
  Scene,
  Spherical,
  type Vector3Tuple,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Controls, type RangeEntry } from './Controls';

export interface FigureOptions {
  /** Place of the camera and the point that it looks at (m). */
  readonly from: Vector3Tuple;
  readonly at: Vector3Tuple;
  /** Vertical field of view (degrees). Default 45. */
  readonly fov?: number;
  readonly near?: number;
  readonly far?: number;
  readonly farol?: FarolOptions;
  /** Whether the canvas has several samples a pixel. Default false. */
  readonly antialias?: boolean;
  /** Largest number of pixels for each CSS pixel, along a side. Default 2. */
  readonly pixelRatio?: number;
}

/** A label over the picture; places are shares of its width and height, from the left and top. */
export interface PictureLabel {
  readonly text: string;
  readonly x: number;
  readonly y: number;
}

/** Turn by an arrow key (radians), and change of distance by + or -. */
const TURN = 0.12;
const STEP = 1.12;
const keyTurns: Record<string, readonly [theta: number, phi: number, distance: number]> = {
  ArrowLeft: [-TURN, 0, 1],
  ArrowRight: [TURN, 0, 1],
  ArrowUp: [0, -TURN, 1],
  ArrowDown: [0, TURN, 1],
  '+': [0, 0, 1 / STEP],
  '-': [0, 0, STEP],
};

/**
 * One figure of the living thesis: a picture that is drawn when something changes, turned by pointer, touch and arrow keys,
 * over a strip of controls and a caption. A figure that moves has a button that stops it; the site's page holds it while it is out of view.
 */
export class Figure {
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  readonly scene = new Scene();
  readonly camera: PerspectiveCamera;
  readonly orbit: OrbitControls;
  readonly controls = new Controls(() => this.redraw());
  /** Lower part of the page: controls, caption, and what a figure adds. */
  readonly strip = document.createElement('div');
  readonly isSpanish = document.documentElement.lang === 'es';
  /** Draws one frame. Default: the scene, by Farol. */
  drawFrame = (): void => this.farol.render(this.scene, this.camera);
  /** Called with the size of the picture (CSS pixels) when it changes. */
  resized: (width: number, height: number) => void = () => {};
  private readonly picture = document.createElement('div');
  private readonly caption = document.createElement('p');
  private readonly labels = document.createElement('div');
  private step: ((seconds: number) => void) | null = null;
  private isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private request = 0;
  private last = 0;
  private labelled = '';

  constructor(options: FigureOptions) {
    const { from, at, fov = 45, near = 0.1, far = 100, antialias = false, pixelRatio = 2 } = options;
    const canvas = document.querySelector('canvas')!;
    document.body.classList.add('figure');
    this.picture.className = 'picture';
    this.labels.className = 'labels';
    this.strip.className = 'strip';
    this.caption.className = 'caption';
    this.caption.setAttribute('aria-live', 'polite');
    this.strip.append(this.controls.element, this.caption);
    this.picture.append(canvas, this.labels);
    document.body.append(this.picture, this.strip);
    this.webgl = new WebGLRenderer({ canvas, antialias });
    this.webgl.setPixelRatio(Math.min(devicePixelRatio, pixelRatio));
    this.farol = new FarolRenderer(this.webgl, { technique: 'deferred', antialias: false, ...options.farol });
    this.farol.addEventListener('redraw', this.redraw);
    this.scene.background = this.backColor();
    this.camera = new PerspectiveCamera(fov, 1, near, far);
    this.camera.position.set(...from);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enablePan = this.orbit.enableZoom = false;
    this.orbit.target.set(...at);
    this.orbit.update();
    this.orbit.addEventListener('change', this.redraw);
    // a finger that moves up or down scrolls the page around the figure
    canvas.style.touchAction = 'pan-y';
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.addEventListener('keydown', this.pressed);
    new ResizeObserver(() => this.fit()).observe(this.picture);
    this.fit();
  }

  /** Picks the one of two texts that is in the page's language. */
  say(english: string, spanish: string): string {
    return this.isSpanish ? spanish : english;
  }

  /** Names the picture, for those who do not see it. */
  describe(english: string, spanish: string): void {
    this.webgl.domElement.setAttribute('aria-label', this.say(english, spanish));
  }

  tell(english: string, spanish: string): void {
    const text = this.say(english, spanish);
    if (this.caption.textContent !== text) this.caption.textContent = text;
  }

  /**
   * Adds the sliders of some lamps.
   * @param range - slider of their ranges (m)
   * @param move - moves them to their places at a time (s)
   */
  lampSliders(
    range: Omit<RangeEntry, 'name' | 'change'>,
    lights: readonly PointLight[],
    move: (seconds: number) => void,
  ): void {
    const change = (value: number): void => lights.forEach((light) => (light.distance = value));
    this.controls.range({ ...range, name: 'range', change });
    const label = this.say('Places', 'Posiciones');
    this.controls.range({ name: 'time', label, value: 0, min: 0, max: 30, step: 0.5, change: move });
  }

  /** Writes labels over the picture, in place of those before. */
  label(labels: readonly PictureLabel[]): void {
    const key = JSON.stringify(labels);
    if (key === this.labelled) return;
    this.labelled = key;
    this.labels.replaceChildren(
      ...labels.map(({ text, x, y }) => {
        const span = document.createElement('span');
        span.textContent = text;
        span.style.left = `${100 * x}%`;
        span.style.top = `${100 * y}%`;
        return span;
      }),
    );
  }

  /** Draws pictures beside one another, in as many columns as fit, each with its label. */
  panels(parts: readonly { readonly text: string; draw(): void }[]): void {
    const { clientWidth, clientHeight } = this.picture;
    // as many columns as leave panels about as wide as high, in full rows
    const counts = parts.map((_, i) => i + 1).filter((count) => parts.length % count === 0);
    const slant = (columns: number): number =>
      Math.abs(Math.log((clientWidth * parts.length) / (1.1 * clientHeight * columns ** 2)));
    const columns = counts.reduce((best, one) => (slant(one) < slant(best) ? one : best));
    const rows = parts.length / columns;
    const [width, height] = [1 / columns, 1 / rows];
    const labels = parts.map(({ text, draw }, i) => {
      const x = (i % columns) * width;
      const y = Math.floor(i / columns) * height;
      this.inPart(x, 1 - y - height, width, height, draw);
      return { text, x: x + width / 2, y: y + 0.02 };
    });
    this.label(labels);
  }

  /**
   * Lets the figure move: `step` is called before each frame with the time that has gone by since it began (s), stops left out.
   */
  animate(step: (seconds: number) => void): void {
    let seconds = 0;
    this.step = (delta) => step((seconds += delta));
    const words = (): string =>
      this.isPlaying ? this.say('Pause', 'Pausar') : this.say('Let it move', 'Dejar que se mueva');
    const button = this.controls.button('play', words(), () => {
      this.isPlaying = !this.isPlaying;
      button.textContent = words();
    });
    step(0);
  }

  /** Draws in the next animation frame. */
  readonly redraw = (): void => {
    if (this.request === 0) this.request = requestAnimationFrame(this.frame);
  };

  /** Draws now. */
  draw(): void {
    if (this.picture.clientWidth > 0) this.drawFrame();
  }

  /** Fulfilled when a picture has been drawn that lacks nothing. */
  async settled(): Promise<void> {
    const again = (): void => this.draw();
    this.farol.addEventListener('redraw', again);
    this.draw();
    await this.farol.ready;
    this.farol.removeEventListener('redraw', again);
    // a caption of more lines leaves less height
    this.fit();
    this.draw();
  }

  /** Draws into a part of the picture, places in shares of its width and height from the left and below. */
  inPart(x: number, y: number, width: number, height: number, draw: () => void): void {
    const { webgl, camera, picture } = this;
    const w = picture.clientWidth;
    const h = picture.clientHeight;
    webgl.setViewport(x * w, y * h, width * w, height * h);
    webgl.setScissor(x * w, y * h, width * w, height * h);
    webgl.setScissorTest(true);
    camera.aspect = (width * w) / (height * h);
    camera.updateProjectionMatrix();
    draw();
    webgl.setScissorTest(false);
    webgl.setViewport(0, 0, w, h);
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
  }

  /** Draws into a part of the picture as if the whole were drawn: a wipe from `x` to `x + width`, in shares. */
  inStripe(x: number, width: number, draw: () => void): void {
    const { webgl, picture } = this;
    const w = picture.clientWidth;
    webgl.setScissor(x * w, 0, width * w, picture.clientHeight);
    webgl.setScissorTest(true);
    draw();
    webgl.setScissorTest(false);
  }

  private backColor(): Color {
    return new Color(document.documentElement.dataset.theme === 'light' ? 0xdde1e8 : 0x0b0d12);
  }

  private readonly frame = (milliseconds: number): void => {
    this.request = 0;
    const delta = Math.min(0.1, Math.max(0, (milliseconds - this.last) / 1000));
    this.last = milliseconds;
    if (this.step !== null && this.isPlaying) {
      this.step(delta);
      this.redraw();
    }
    this.draw();
  };

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.picture;
    if (width === 0 || height === 0) return;
    this.webgl.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.resized(width, height);
    this.redraw();
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    const turn = keyTurns[event.key];
    if (turn === undefined || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const { camera, orbit } = this;
    const offset = new Vector3().subVectors(camera.position, orbit.target);
    const around = new Spherical().setFromVector3(offset);
    around.set(around.radius * turn[2], around.phi + turn[1], around.theta + turn[0]).makeSafe();
    camera.position.setFromSpherical(around).add(orbit.target);
    orbit.update();
    this.redraw();
  };
}
