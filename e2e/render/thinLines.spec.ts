import { expect, test } from '../support/benchTest';

/** Half floats of the picture, over the pixels of a square. */
const ROUNDING = 5e-3;

test('SMAA brings every thin line nearer to a supersampled one, or leaves it as it is, and none is broken into dashes', async ({
  benchPage: page,
}) => {
  const lines = await page.evaluate(() => {
    const { Bench, CELL, effects, lineSheet, supersampled } = window.testPage;
    const { scene, camera, width, height, lines } = lineSheet();
    const wanted = supersampled(width, height, scene, camera);
    const bench = new Bench(width, height);
    const none = bench.byTechnique('forward-single-pass', scene, camera);
    bench.farol.effects = [new effects.SMAA()];
    const smaa = bench.byTechnique('forward-single-pass', scene, camera);
    type Picture = typeof wanted;
    const at = ({ data }: Picture, x: number, y: number) => data[(y * width + x) * 4];
    return lines.map(({ name, x, y, shallow }) => {
      const ground = at(none, x + 1, y + 1);
      const error = (picture: Picture) => {
        let sum = 0;
        for (let i = 0; i < CELL * CELL; i++) {
          const [px, py] = [x + (i % CELL), y + Math.floor(i / CELL)];
          sum += (at(picture, px, py) - at(wanted, px, py)) ** 2;
        }
        return Math.sqrt(sum);
      };
      /** Least that the line has in a column, or a row if it is steep, but near its ends; 1: as much as supersampled. */
      const least = (picture: Picture) => {
        const ink = (of: Picture, along: number) => {
          let sum = 0;
          for (let across = 0; across < CELL; across++) {
            const value = shallow ? at(of, x + along, y + across) : at(of, x + across, y + along);
            sum += Math.abs(value - ground);
          }
          return sum;
        };
        const inner = Array.from({ length: 18 }, (_, i) => CELL / 2 - 9 + i);
        return Math.min(...inner.map((along) => ink(picture, along) / ink(wanted, along)));
      };
      return { name, errors: [error(none), error(smaa)], least: [least(none), least(smaa)] };
    });
  });
  for (const { name, errors, least } of lines) {
    const isAligned = /^(horizontal|vertical)/.test(name);
    expect
      .soft(errors[1], `${name}: distance, ${errors[0]} without`)
      .toBeLessThan(isAligned ? errors[0] + ROUNDING : 0.95 * errors[0]);
    expect.soft(least[1], `${name}: least of the line, ${least[0]} without`).toBeGreaterThan(0.95 * least[0]);
  }
});

test("SMAA leaves thin lines that their own shader smooths, as drei's Grid does, unblurred at their crossings", async ({
  benchPage: page,
}) => {
  const pairs = await page.evaluate(() => {
    const { Bench, compareImages, effects, supersampled, three } = window.testPage;
    const [width, height] = [320, 180];
    const material = new three.ShaderMaterial({
      transparent: true,
      // pixels: number of pixels of the picture in one that counts
      uniforms: { thickness: { value: 1 }, pixels: { value: 1 } },
      vertexShader: `varying vec2 place;
        void main() { place = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
      fragmentShader: `varying vec2 place;
        uniform float thickness;
        uniform float pixels;
        void main() {
          vec2 cell = place / 0.5;
          vec2 away = abs(fract(cell - 0.5) - 0.5) / (pixels * fwidth(cell));
          gl_FragColor = vec4(vec3(0.8), 1.0 - min(min(away.x, away.y) + 1.0 - thickness, 1.0));
          #include <colorspace_fragment>
        }`,
    });
    const plane = new three.Mesh(new three.PlaneGeometry(20, 20), material);
    plane.rotation.x = -Math.PI / 2;
    const scene = new three.Scene();
    scene.background = new three.Color(0.02, 0.02, 0.02);
    scene.add(plane);
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 60);
    camera.position.set(0.3, 1.1, 4);
    camera.lookAt(0.2, 0.3, 0);
    const bench = new Bench(width, height);
    const smaa = new effects.SMAA();
    return [0.5, 1, 1.5].map((thickness) => {
      material.uniforms.thickness.value = thickness;
      material.uniforms.pixels.value = 4;
      const wanted = supersampled(width, height, scene, camera);
      material.uniforms.pixels.value = 1;
      const [none, smooth] = [[], [smaa]].map((each) => {
        bench.farol.effects = each;
        return compareImages(wanted, bench.byTechnique('forward-single-pass', scene, camera)).psnr;
      });
      return { thickness, none, smooth };
    });
  });
  for (const { thickness, none, smooth } of pairs)
    expect.soft(smooth, `lines ${thickness} px thick, ${none} dB without`).toBeGreaterThan(none - 0.25);
});
