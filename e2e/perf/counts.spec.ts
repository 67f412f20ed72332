import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

/** How many lights, or draws, are as hot as can be. */
const HOTTEST = 16;

/** The count that a colour stands for: the inverse of output/heatMap.glsl, whose claims claims.spec.ts holds. */
function countOf([red, green, blue]: number[]): number {
  if (red === 0 && green === 0 && blue === 0) return 0;
  const t = blue >= 1 ? green : blue > 0 ? 2 - blue : red < 1 ? 2 + red : 4 - green;
  return (t / 4) * HOTTEST;
}

/** Planes one behind the other. */
const LAYERS = 5;

/** Points of a wall and how many of the lights before it reach each one. */
const stacks = [0, 1, 3, 7];
const LIGHTS = stacks.reduce((sum, count) => sum + count, 0);

test('the light count of a pixel is what the technique evaluates there', async ({ page }) => {
  const measured = await page.evaluate(
    ([hottest, stacks]) => {
      const { perf, testPage } = window;
      const { three } = testPage;
      const [width, height] = [128, 32];
      const bench = new testPage.Bench(width, height);
      bench.farol.heatMapMaximum = hottest;
      bench.farol.view = 'light-count';
      const scene = new three.Scene();
      const camera = new three.OrthographicCamera(-8, 8, 2, -2, 0.1, 10);
      camera.position.z = 5;
      scene.add(new three.Mesh(new three.PlaneGeometry(16, 4), new three.MeshStandardMaterial()));
      stacks.forEach((count, stack) => {
        for (let i = 0; i < count; i++) {
          const light = new three.PointLight(0xffffff, 1, 1);
          light.position.set(4 * stack - 6, 0, 0.2 + 0.05 * i); // 4 apart, 1 m of range: no stack reaches another
          scene.add(light);
        }
      });
      return perf.techniques.map((technique) => {
        const { data } = bench.byTechnique(technique, scene, camera);
        const colours = stacks.map((_, stack) => {
          const pixel = 4 * ((height / 2) * width + (stack + 0.5) * (width / stacks.length));
          return Array.from(data.slice(pixel, pixel + 3));
        });
        return { technique, drawn: bench.farol.info.technique, colours };
      });
    },
    [HOTTEST, stacks] as const,
  );

  for (const { technique, drawn, colours } of measured) {
    const counts = colours.map(countOf);
    // 4 m are 32 pixels: lists of tiles of up to 32 pixels, volumes and scissors all tell these stacks apart
    const listed = drawn === 'forward-single-pass' ? stacks.map(() => LIGHTS) : stacks;
    counts.forEach((count, stack) => {
      const wanted = listed[stack] * budgetOf(drawn).lightings;
      expect(count, `${technique}: lights evaluated where ${stacks[stack]} reach the pixel`).toBeCloseTo(wanted, 1);
    });
  }
});

/** Lights between a near and a far wall, of which none reaches either. */
const BETWEEN = 8;

test('lists by depth leave out the lights in the gap behind an edge', async ({ page }) => {
  const measured = await page.evaluate(
    ([hottest, between]) => {
      const { testPage } = window;
      const { three } = testPage;
      const [width, height] = [64, 32];
      const bench = new testPage.Bench(width, height);
      bench.farol.heatMapMaximum = hottest;
      bench.farol.view = 'light-count';
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(40, width / height, 0.5, 50);
      const wall = (x: number, distance: number) => {
        const mesh = new three.Mesh(new three.PlaneGeometry(60, 60), new three.MeshStandardMaterial());
        mesh.position.set(x, 0, -distance);
        scene.add(mesh);
      };
      wall(0, 20);
      // its edge is 1.5 pixels right of the middle: inside a block of 4 pixels and a tile of 16
      wall(0.17 - 30, 5);
      for (let i = 0; i < between; i++) {
        const light = new three.PointLight(0xffffff, 1, 1);
        light.position.set(0.1 * i, 0, -8 - i);
        scene.add(light);
      }
      return (['tiled-deferred', 'forward-plus'] as const).map((technique) => {
        const { data } = bench.byTechnique(technique, scene, camera);
        const row = (height / 2) * width;
        return {
          technique,
          colours: [30, 31, 32, 33, 34, 35, 40].map((x) => Array.from(data.slice(4 * (row + x), 4 * (row + x) + 3))),
        };
      });
    },
    [HOTTEST, BETWEEN] as const,
  );
  for (const { technique, colours } of measured)
    expect(colours.map(countOf), `${technique}: lights evaluated beside the edge`).toEqual(colours.map(() => 0));
});

test('the overdraw of a pixel is how often it is shaded', async ({ page }) => {
  const measured = await page.evaluate(
    ([hottest, layers]) => {
      const { perf, testPage } = window;
      const { three } = testPage;
      const bench = new testPage.Bench(32, 32);
      bench.farol.heatMapMaximum = hottest;
      bench.farol.view = 'overdraw';
      const camera = new three.OrthographicCamera(-1, 1, 1, -1, 0.1, 20);
      camera.position.z = 10;
      const draw = (technique: (typeof perf.techniques)[number], count: number, nearFirst: boolean) => {
        const scene = new three.Scene();
        for (let i = 0; i < count; i++) {
          const layer = new three.Mesh(new three.PlaneGeometry(2, 2), new three.MeshStandardMaterial());
          layer.position.z = i; // the last is the nearest
          layer.renderOrder = nearFirst ? -i : i;
          scene.add(layer);
        }
        const { data } = bench.byTechnique(technique, scene, camera);
        return Array.from(data.slice(4 * 528, 4 * 528 + 3));
      };
      return perf.techniques.map((technique) => ({
        ...{ technique, farFirst: draw(technique, layers, false), nearFirst: draw(technique, layers, true) },
        ...{ drawn: bench.farol.info.technique, none: draw(technique, 0, true) },
      }));
    },
    [HOTTEST, LAYERS] as const,
  );

  for (const { technique, drawn, farFirst, nearFirst, none } of measured) {
    const { shadings, depthFirst } = budgetOf(drawn);
    expect(countOf(none), `${technique}: an empty scene`).toBe(0);
    expect(countOf(nearFirst), `${technique}: the nearest of ${LAYERS} layers first`).toBeCloseTo(shadings, 1);
    const all = depthFirst ? shadings : LAYERS * shadings;
    expect(countOf(farFirst), `${technique}: the farthest of ${LAYERS} layers first`).toBeCloseTo(all, 1);
  }
});
