import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

/** PSNR (dB) against stock three with 16 samples a pixel, of pictures of one scene of edges. */
type Figures = Record<string, number>;

const WIDTH = 240;
const HEIGHT = 160;
const FORWARD = ['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward'] as const;

function note(figures: Figures): void {
  const text = Object.entries(figures).map(([name, psnr]) => `${name} ${psnr.toFixed(1)} dB`);
  test.info().annotations.push({ type: 'anti-aliasing', description: text.join(', ') });
}

test('as stock three with 4 samples are the forward techniques in a multisampled target, and deferred shading by MultisampledEdges @software', async ({
  benchPage: page,
}) => {
  const { figures, apart, stays, green, drawn } = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, edgeScene, effects, supersampled, techniquesInTurn, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      const wanted = supersampled(width, height, scene, camera);
      const multi = new Bench(width, height, { samples: 4 });
      const stock = multi.stock(scene, camera);
      const figures: Record<string, number> = {
        none: compareImages(wanted, new Bench(width, height).stock(scene, camera)).psnr,
        stock: compareImages(wanted, stock).psnr,
      };
      const apart: Record<string, ReturnType<typeof compareImages>> = {};
      const drawn = techniquesInTurn(3, techniques);
      for (const technique of drawn) {
        const image = multi.byTechnique(technique, scene, camera);
        figures[technique] = compareImages(wanted, image).psnr;
        apart[technique] = compareImages(stock, image);
      }
      const bench = new Bench(width, height);
      const edges = new effects.MultisampledEdges();
      const deferred = (name: string) => {
        bench.farol.effects = [edges];
        const image = bench.byTechnique('deferred', scene, camera);
        figures[name] = compareImages(wanted, image).psnr;
        apart[name] = compareImages(stock, image);
      };
      deferred('edges');
      edges.shadedLights = 0;
      deferred('edges, colours of pixels nearby');
      edges.mostLights = 0;
      deferred('edges, nothing shaded');
      edges.mostLights = 128;
      // what is not drawn anew stays as it is: a shader of the host's, and glass with what is seen through it
      const fragmentShader = 'void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }';
      const own = new three.Mesh(new three.SphereGeometry(0.7), new three.ShaderMaterial({ fragmentShader }));
      const glass = new three.MeshStandardMaterial({ transparent: true, opacity: 0.5 });
      own.position.set(0.5, 0.5, 2);
      const pane = new three.Mesh(new three.BoxGeometry(1.5, 1.5, 0.2), glass);
      pane.position.set(-2, -0.5, 2.5);
      scene.add(own, pane);
      bench.farol.effects = [];
      const plain = bench.byTechnique('deferred', scene, camera);
      bench.farol.effects = [edges];
      const left = bench.byTechnique('deferred', scene, camera);
      const at = (x: number, y: number) => ((height >> 1) + y) * width * 4 + ((width >> 1) + x) * 4;
      const kept = [at(14, 1), at(14, 12), at(-64, -36), at(-50, -30)];
      const stays = Math.max(...kept.map((i) => Math.abs(left.data[i] - plain.data[i])));
      const green = plain.data[kept[0] + 1];
      return { figures, apart, stays, green, drawn };
    },
    [WIDTH, HEIGHT, FORWARD] as const,
  );
  note(figures);
  expect(figures.stock, 'the scene has edges to smooth').toBeGreaterThan(figures.none + 6);
  expect(figures.edges).toBeGreaterThan(figures.stock - 0.2);
  // but where an edge lies within rounding of a pixel's middle: there it may be the other side's
  expect(apart.edges.psnr).toBeGreaterThan(54);
  expect(figures['edges, colours of pixels nearby']).toBeGreaterThan(figures.stock - 0.5);
  expect(figures['edges, nothing shaded']).toBeGreaterThan(figures.none + 6);
  expect(figures['edges, nothing shaded']).toBeLessThan(figures['edges, colours of pixels nearby'] - 1);
  expect(green).toBe(1);
  expect(stays).toBeLessThan(1e-3);
  for (const technique of drawn) {
    expect(figures[technique], technique).toBeGreaterThan(figures.stock - 0.1);
    // Half floats, in which forward adds light by light. The lists of forward-plus are for the depths at pixel centres: a
    // sample of an edge may lie outside of them and miss a light.
    if (technique === 'forward-plus') expect(apart[technique].share, technique).toBeLessThan(1e-3);
    else expect(apart[technique].largest, technique).toBeLessThan(technique === 'forward' ? 4e-3 : 1e-3);
  }
});

test('where a target is multisampled too, forward-plus shades nothing of what is hidden', async ({
  benchPage: page,
}) => {
  const shaded = await page.evaluate(async () => {
    const { Bench, three } = window.testPage;
    const bench = new Bench(64, 64, { samples: 4 });
    const gl = bench.webgl.getContext() as WebGL2RenderingContext;
    const camera = new three.PerspectiveCamera(45, 1, 0.1, 50);
    camera.position.z = 5;
    const scene = new three.Scene();
    scene.add(new three.PointLight(0xffffff, 20));
    const queries = new Map<string, WebGLQuery>();
    // of one material each, they are drawn in this order
    for (const [name, z, radius] of [
      ['hidden', -3, 0.5],
      ['before it', 0, 1],
    ] as const) {
      const mesh = new three.Mesh(new three.SphereGeometry(radius), new three.MeshStandardMaterial());
      mesh.position.z = z;
      mesh.onBeforeRender = () => {
        queries.set(name, gl.createQuery()); // of the last draw in the frame: the one that shades
        gl.beginQuery(gl.ANY_SAMPLES_PASSED, queries.get(name)!);
      };
      mesh.onAfterRender = () => gl.endQuery(gl.ANY_SAMPLES_PASSED);
      scene.add(mesh);
    }
    const results: Record<string, string[]> = {};
    for (const technique of ['tiled-forward', 'forward-plus'] as const) {
      bench.byTechnique(technique, scene, camera);
      const all = [...queries.values()];
      const ready = () => all.every((query) => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE));
      while (!ready()) await new Promise(requestAnimationFrame);
      results[technique] = [...queries.keys()].filter((name) =>
        gl.getQueryParameter(queries.get(name)!, gl.QUERY_RESULT),
      );
    }
    return results;
  });
  expect(shaded).toEqual({ 'tiled-forward': ['hidden', 'before it'], 'forward-plus': ['before it'] });
});

test('SMAA and TAA bring deferred shading nearer to 16 samples; still, TAA is nearer than 4 samples, and nothing of the past stays @software @verify', async ({
  benchPage: page,
}) => {
  const figures = await page.evaluate(
    ([width, height, isWhole]) => {
      const { Bench, compareImages, edgeScene, effects, supersampled } = window.testPage;
      const { scene, camera, setTime, lights } = edgeScene(width, height);
      let wanted = supersampled(width, height, scene, camera);
      const bench = new Bench(width, height);
      const deferred = () => bench.byTechnique('deferred', scene, camera);
      const psnr = (image: ReturnType<typeof deferred>) => compareImages(wanted, image).psnr;
      const figures: Record<string, number> = {
        'MSAA 4x': psnr(new Bench(width, height, { samples: 4 }).stock(scene, camera)),
        none: psnr(deferred()),
      };
      bench.farol.effects = [new effects.SMAA()];
      figures.SMAA = psnr(deferred());
      let taa = new effects.TAA();
      bench.farol.effects = [taa];
      const frames = (count: number, move: (left: number) => void) => {
        let image!: ReturnType<typeof deferred>;
        taa.reset();
        for (let i = count - 1; i >= 0; i--) {
          move(i);
          image = deferred();
        }
        return psnr(image);
      };
      figures['TAA still'] = frames(32, () => {});
      figures['TAA, camera moving'] = frames(20, (left) => {
        camera.position.x = 0.02 * left;
        camera.rotation.y = -0.002 * left;
      });
      if (!isWhole) return figures;
      // the samples of a frame may miss a bar of the fence
      figures['TAA, camera moving slowly'] = frames(20, (left) => (camera.position.x = 0.004 * left));
      figures['TAA, objects moving'] = frames(20, (left) => setTime(-0.01 * left));

      const [, lamp] = lights;
      const box = scene.children[9];
      const afterwards = (change: () => void) => {
        frames(12, () => {});
        change();
        wanted = supersampled(width, height, scene, camera);
        for (let i = 0; i < 3; i++) deferred();
        return psnr(deferred());
      };
      figures['TAA, 4 frames after a light goes out'] = afterwards(() => (lamp.intensity = 0));
      figures['TAA, 4 frames after an object jumps'] = afterwards(() => (box.position.x += 1));
      figures['TAA, an object flying off'] = frames(10, (left) => (box.position.x = -0.2 + 0.15 * left));
      setTime(0);
      lamp.intensity = 30;
      wanted = supersampled(width, height, scene, camera);
      taa = new effects.TAA({ cells: 1 });
      bench.farol.effects = [taa];
      figures['TAA of one cell, objects moving'] = frames(20, (left) => setTime(-0.01 * left));
      return figures;
    },
    [WIDTH, HEIGHT, isWhole] as const,
  );
  note(figures);
  expect(figures.SMAA).toBeGreaterThan(figures.none + 2.3);
  expect(figures['TAA still']).toBeGreaterThan(figures['MSAA 4x'] + 3);
  expect(figures['TAA, camera moving']).toBeGreaterThan(figures.none + 8.6);
  if (!isWhole) return;
  expect(figures['TAA, camera moving slowly']).toBeGreaterThan(figures.none + 9.4);
  expect(figures['TAA, objects moving']).toBeGreaterThan(figures.none + 9.2);
  expect(figures['TAA of one cell, objects moving']).toBeGreaterThan(figures.none + 8.4);
  // nothing of what was there before: as near as a picture of a few frames is anyway
  expect(figures['TAA, 4 frames after a light goes out']).toBeGreaterThan(35.5);
  expect(figures['TAA, 4 frames after an object jumps']).toBeGreaterThan(41.2);
  expect(figures['TAA, an object flying off']).toBeGreaterThan(38.7);
});

test('TAA knows the motion of objects, skins, morphs, instances and batches: alone in view, each stays where it is drawn @software @verify', async ({
  benchPage: page,
}) => {
  const figures = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, edgeScene, effects, three } = window.testPage;
      const { scene, camera, setTime } = edgeScene(width, height);
      const bench = new Bench(width, height);
      const taa = new effects.TAA();
      // nothing of the past is cut off, and it counts much: all of it must be where it belongs
      taa.gamma = 1000;
      taa.share = 0.3;
      const movers = scene.children.slice(9, 14);
      scene.background = new three.Color(0, 0, 0);
      for (const child of scene.children) child.visible = (child as { isLight?: boolean }).isLight === true;
      return movers.map((mover) => {
        mover.visible = true;
        bench.farol.effects = [];
        setTime(0);
        const now = bench.byTechnique('deferred', scene, camera);
        bench.farol.effects = [taa];
        taa.reset();
        let image = now;
        for (let i = 5; i >= 0; i--) {
          setTime(-0.1 * i);
          image = bench.byTechnique('deferred', scene, camera);
        }
        mover.visible = false;
        return compareImages(now, image).psnr;
      });
    },
    [WIDTH, HEIGHT] as const,
  );
  // without their motion: 28.1, 27.2, 35.8, 27.2 and 32.2 dB
  const least = { object: 35.5, skin: 32.4, morph: 45, instances: 34, batch: 38 };
  test.info().annotations.push({ type: 'motion', description: figures.map((psnr) => psnr.toFixed(1)).join(', ') });
  Object.entries(least).forEach(([name, psnr], i) => expect(figures[i], name).toBeGreaterThan(psnr));
});

test('TAA knows the motion of what components Animation move: an object, a part of a model, a skin by its bone', async ({
  benchPage: page,
}) => {
  const figures = await page.evaluate(
    async ([width, height]) => {
      const { animatedScene, Bench, compareImages, effects } = window.testPage;
      const { scene, camera, movers, setTime } = (await animatedScene()).animatedScene(width, height);
      const bench = new Bench(width, height);
      const taa = new effects.TAA();
      // as above: all of the past must be where it belongs
      taa.gamma = 1000;
      taa.share = 0.3;
      const all = Object.values(movers);
      return Object.entries(movers).map(([name, mover]): [string, number] => {
        for (const each of all) each.visible = each === mover;
        bench.farol.effects = [];
        setTime(1.5);
        const now = bench.byTechnique('deferred', scene, camera);
        bench.farol.effects = [taa];
        taa.reset();
        let image = now;
        for (let i = 5; i >= 0; i--) {
          setTime(1.5 - 0.1 * i);
          image = bench.byTechnique('deferred', scene, camera);
        }
        return [name, compareImages(now, image).psnr];
      });
    },
    [WIDTH, HEIGHT] as const,
  );
  test.info().annotations.push({ type: 'motion', description: figures.join(', ') });
  // without their motion: 27.7, 29.1 and 26.1 dB
  const least: Readonly<Record<string, number>> = { object: 37, node: 37, skin: 33.5 };
  for (const [name, psnr] of figures) expect(psnr, name).toBeGreaterThan(least[name]);
});

test('TAA forgets the past when the size changes and when the camera cuts, and leaves the host as it was', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate(() => {
    const { Bench, compareImages, edgeScene, effects } = window.testPage;
    const { scene, camera } = edgeScene(96, 64);
    const bench = new Bench(96, 64);
    const taa = new effects.TAA();
    const first = (turn: number) => {
      bench.farol.effects = [taa];
      camera.rotation.y = turn;
      return bench.byTechnique('deferred', scene, camera);
    };
    const fresh = first(0);
    for (let i = 0; i < 5; i++) first(0);
    const keys = Object.keys(camera).join();
    const projection = camera.projectionMatrix.elements.join();
    first(2.5);
    const back = first(0); // a cut: as the first frame was
    taa.reset();
    const again = first(0); // although nothing has changed
    bench.target.setSize(64, 48);
    first(0);
    return {
      cut: compareImages(fresh, back).largest,
      reset: compareImages(fresh, again).largest,
      same: Object.keys(camera).join() === keys && camera.projectionMatrix.elements.join() === projection,
      target: bench.webgl.getRenderTarget() === null,
      bytes: bench.farol.info.targetBytes > 0,
    };
  });
  expect(result.cut).toBeLessThan(1e-3);
  expect(result.reset).toBeLessThan(1e-3);
  expect(result.same).toBe(true);
  expect(result.target).toBe(true);
});

for (const kind of ['logarithmicDepthBuffer', 'reversedDepthBuffer'] as const) {
  test(`TAA follows the camera with ${kind}, and MultisampledEdges finds its surfaces @verify`, async ({
    benchPage: page,
  }) => {
    const { taa, edges, without, has } = await page.evaluate(
      ([width, height, kind]) => {
        const { Bench, compareImages, edgeScene, effects, supersampled } = window.testPage;
        const { scene, camera } = edgeScene(width, height);
        const wanted = supersampled(width, height, scene, camera);
        const bench = new Bench(width, height, { renderer: { [kind]: true } });
        const { webgl, farol: renderer } = bench;
        const draw = () => compareImages(wanted, bench.byTechnique('forward-single-pass', scene, camera)).psnr;
        const without = draw();
        renderer.effects = [new effects.TAA()];
        let taa = 0;
        for (let left = 11; left >= 0; left--) {
          camera.position.x = 0.05 * left;
          taa = draw();
        }
        renderer.effects = [new effects.MultisampledEdges()];
        return { taa, edges: draw(), without, has: webgl.capabilities[kind] };
      },
      [WIDTH, HEIGHT, kind] as const,
    );
    test.info().annotations.push({ type: 'depth', description: `${has}: ${without} to ${taa}, ${edges} dB` });
    expect(taa).toBeGreaterThan(without + 5);
    expect(edges).toBeGreaterThan(40.8);
  });
}
