import * as THREE from 'three';
import { atRelease, Bench } from './Bench';

export { atRelease };

/** A picture whose pixels each cost as much as is asked for: a frame's cost goes with the scale that it is drawn at. */
export class BudgetLoad {
  readonly bench: Bench;
  /** Work of each pixel (steps of a loop). */
  readonly steps = { value: 1 };
  /** Pixels times steps of all frames so far. */
  work = 0;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 2);

  constructor(width: number, height: number) {
    this.bench = new Bench(width, height);
    const gl = this.bench.webgl.getContext();
    const material = new THREE.ShaderMaterial({
      uniforms: { steps: this.steps },
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.5, 1.0); }',
      fragmentShader: `uniform int steps;
        void main() {
          vec4 sum = gl_FragCoord;
          for (int i = 0; i < steps; i++) sum = fract(sum.yzwx * 1.7 + 0.1);
          gl_FragColor = sum;
        }`,
    });
    const sheet = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    sheet.frustumCulled = false;
    sheet.onBeforeRender = () => {
      const [, , width, height] = gl.getParameter(gl.VIEWPORT) as Int32Array;
      this.work += width * height * this.steps.value;
    };
    this.scene.add(sheet);
    this.bench.farol.technique = 'forward-single-pass';
  }

  /** Hides the GPU's timer, so that budgets go by intervals. */
  hideTimer(): void {
    const gl = this.bench.webgl.getContext();
    const getExtension = gl.getExtension.bind(gl) as (name: string) => unknown;
    Object.assign(gl, { getExtension: (name: string) => (/timer_query/.test(name) ? null : getExtension(name)) });
  }

  draw(): void {
    this.bench.farol.render(this.scene, this.camera);
  }

  /** Draws so many frames, one a turn of the event loop, each finished before the next. @returns scales that they were drawn at */
  async frames(count: number): Promise<number[]> {
    const { farol, webgl } = this.bench;
    const gl = webgl.getContext();
    const scales: number[] = [];
    const { port1, port2 } = new MessageChannel();
    port1.start();
    for (let i = 0; i < count; i++) {
      this.draw();
      // waits for the GPU, as a display does
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      scales.push(farol.info.budget?.scale ?? 1);
      await new Promise((resolve) => {
        port1.addEventListener('message', resolve, { once: true });
        port2.postMessage(null);
      });
    }
    port1.close();
    return scales;
  }
}
