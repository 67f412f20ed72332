import { byExtent } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

/** A box before a plane, one pixel a metre. */
const SIZE = 48;

test('the view of motion has direction and pixels, and leaves no trace; views without a buffer name the mend', async ({
  benchPage: page,
  watch,
}) => {
  const { seen, problems, changed, info } = await page.evaluate(async (size) => {
    const { Bench, compareImages, effects, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const bench = new Bench(size, size);
    const { farol: renderer } = bench;
    const camera = new three.OrthographicCamera(-size / 2, size / 2, size / 2, -size / 2, 1, 100);
    camera.position.z = 50;
    const box = new three.Mesh(new three.BoxGeometry(16, 16, 16), new three.MeshLambertMaterial());
    const wall = new three.Mesh(new three.PlaneGeometry(200, 200), new three.MeshLambertMaterial({ color: 0x808080 }));
    wall.position.z = -20;
    const scene = new three.Scene().add(box, wall, new three.AmbientLight(0xffffff, 2));
    const draw = () => bench.byTechnique('forward-single-pass', scene, camera);
    const final = draw();
    const problems: Record<string, string | null> = {};
    const changed: Record<string, number> = {};
    for (const view of farol.views.slice(farol.views.indexOf('grid') + 1)) {
      renderer.view = view;
      changed[view] = compareImages(final, draw()).largest;
      problems[view] = renderer.info.view!.problem;
    }
    renderer.effects = [new effects.TAA()];
    renderer.view = 'motion';
    const moved = (x: number, y: number, cameraX = 0) => {
      box.position.set(0, 0, 0);
      camera.position.x = 0;
      draw();
      box.position.set(x, y, 0);
      camera.position.x = cameraX;
      const { data } = draw();
      const at = (pixelX: number, pixelY: number) => [
        ...data.slice(4 * (pixelY * size + pixelX), 4 * (pixelY * size + pixelX) + 3),
      ];
      return { box: at(size / 2 + x - cameraX, size / 2 + y), wall: at(2, 2) };
    };
    const seen = { right: moved(5, 0), leftUp: moved(-4, 3), camera: moved(0, 0, 2), still: moved(0, 0) };
    const info = { ...renderer.info.view!, tiles: renderer.info.view!.tiles.length };
    // with effects the picture is the one without the view
    renderer.effects = [];
    renderer.view = 'final';
    changed.after = compareImages(final, draw()).largest;
    return { seen, problems, changed, info };
  }, SIZE);
  const near = (value: number[], wanted: number[], what: string) =>
    value.forEach((channel, i) => expect.soft(Math.abs(channel - wanted[i]), `${what}: ${value}`).toBeLessThan(0.002));
  near(seen.right.box, [5 / 16, 0, 0], 'five pixels to the right');
  near(seen.right.wall, [0, 0, 0], 'what stands still');
  // five pixels, at 143°: between green (120°) and cyan (180°)
  const turn = (Math.atan2(3, -4) * 180) / Math.PI;
  near(seen.leftUp.box, [0, 5 / 16, ((turn - 120) / 60) * (5 / 16)], 'to the left and up');
  near(seen.camera.box, [0, 2 / 16, 2 / 16], 'to the left, as the camera goes to the right');
  near(seen.camera.wall, [0, 2 / 16, 2 / 16], 'the wall likewise');
  near(seen.still.box, [0, 0, 0], 'nothing moves');
  expect(info).toEqual({ view: 'motion', problem: null, fullMotion: 16, tiles: 0 });
  expect(Object.keys(problems)).toHaveLength(9);
  for (const [view, problem] of Object.entries(problems)) {
    expect.soft(problem, view).toMatch(/switch it on|switch on|choose|let a light|give a light/);
    expect.soft(changed[view], `${view} is the final picture`).toBe(0);
  }
  expect(changed.after).toBe(0);
  // one sentence serves the three views of fog
  expect(watch.forgive(/shows the final picture/)).toBe(7);
});

test('the view of motion is the same by every technique @verify', async ({ benchPage: page }) => {
  const rows = await page.evaluate(async (size) => {
    const { Bench, drawn, effects, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const bench = new Bench(size, size);
    const camera = new three.PerspectiveCamera(90, 1, 0.1, 100);
    camera.position.z = size / 2;
    // at this distance a pixel is a metre
    const plane = new three.Mesh(new three.PlaneGeometry(16, 16), new three.MeshStandardMaterial());
    const scene = new three.Scene().add(
      plane,
      new three.AmbientLight(0xffffff, 2),
      new three.PointLight(0xffffff, 9, 9),
    );
    bench.farol.view = 'motion';
    return drawn.map((technique) => {
      bench.farol.effects = [new effects.TAA()];
      plane.position.x = 0;
      bench.byTechnique(technique, scene, camera);
      plane.position.x = 5;
      const { data } = bench.byTechnique(technique, scene, camera);
      const at = 4 * ((size / 2) * size + size / 2 + 5);
      return { technique, value: [...data.slice(at, at + 3)] };
    });
  }, SIZE);
  expect(rows).toHaveLength(10);
  for (const { technique, value } of rows) {
    [5 / 16, 0, 0].forEach((wanted, i) =>
      expect.soft(Math.abs(value[i] - wanted), `${technique}: ${value}`).toBeLessThan(0.002),
    );
  }
});

test('the view of ambient occlusion is the share of light that is left, by every technique that has it @verify', async ({
  benchPage: page,
}) => {
  const rows = await page.evaluate(async () => {
    const { Bench, effects, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const [width, height] = [96, 72];
    const bench = new Bench(width, height);
    const material = new three.MeshStandardMaterial({ roughness: 1 });
    const floor = new three.Mesh(new three.PlaneGeometry(40, 40), material);
    floor.rotation.x = -Math.PI / 2;
    const wall = new three.Mesh(new three.PlaneGeometry(40, 40), material);
    const scene = new three.Scene().add(floor, wall, new three.AmbientLight(0xffffff, 1));
    const camera = new three.PerspectiveCamera(60, width / height, 0.1, 100);
    camera.position.set(0, 3, 6);
    camera.lookAt(0, 0, 0);
    const ao = new effects.AmbientOcclusion();
    ao.radius = 2;
    return (['deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass', 'forward-plus'] as const).map(
      (technique) => {
        bench.farol.view = 'final';
        bench.farol.effects = [];
        const open = bench.byTechnique(technique, scene, camera);
        bench.farol.effects = [ao];
        const closed = bench.byTechnique(technique, scene, camera);
        bench.farol.view = 'ambient-occlusion';
        const shown = bench.byTechnique(technique, scene, camera);
        const { problem } = bench.farol.info.view!;
        let off = 0;
        for (let i = 0; i < shown.data.length; i += 4)
          off = Math.max(off, Math.abs(shown.data[i] - closed.data[i] / open.data[i]));
        const corner = new three.Vector3(0, 0, 0).project(camera);
        const row = Math.round((corner.y * 0.5 + 0.5) * height);
        const at = (y: number) => shown.data[(y * width + width / 2) * 4];
        return { technique, problem, off, corner: at(row - 2), far: at(4) };
      },
    );
  });
  for (const { technique, problem, off, corner, far } of rows) {
    expect.soft(problem, technique).toBeNull();
    // 8 bits hold it
    expect.soft(off, `${technique}, beside the light that is left`).toBeLessThan(0.006);
    expect.soft(corner, technique).toBeLessThan(0.7);
    expect.soft(far, technique).toBeGreaterThan(0.95);
  }
});

test('the view of the light buffer is the light on surfaces without their colours @verify', async ({
  benchPage: page,
}) => {
  const rows = await page.evaluate(async () => {
    const { Bench, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const [width, height] = [64, 48];
    const bench = new Bench(width, height);
    const plane = new three.Mesh(new three.PlaneGeometry(40, 40), new three.MeshLambertMaterial({ color: 0xffffff }));
    const light = new three.PointLight(new three.Color(1, 0.5, 0.25), 30, 20);
    light.position.set(1, 0.5, 2);
    const scene = new three.Scene().add(plane, light);
    const camera = new three.PerspectiveCamera(60, width / height, 0.1, 100);
    camera.position.set(0, 0, 5);
    return (['light-prepass', 'inferred'] as const).map((technique) => {
      bench.farol.inferredScale = 1;
      bench.farol.view = 'final';
      const picture = bench.byTechnique(technique, scene, camera);
      bench.farol.view = 'light-buffer';
      const shown = bench.byTechnique(technique, scene, camera);
      const { problem, tiles } = bench.farol.info.view!;
      let off = 0;
      let brightest = 0;
      // the upper left quarter has every second texel
      for (let y = 0; y < height / 2; y++)
        for (let x = 0; x < width / 2; x++) {
          const there = 4 * ((2 * y + 1) * width + 2 * x + 1);
          const here = 4 * ((y + height / 2) * width + x);
          for (let k = 0; k < 3; k++) {
            const diffuse = picture.data[there + k] * Math.PI;
            off = Math.max(off, Math.abs(shown.data[here + k] - diffuse) / diffuse);
            brightest = Math.max(brightest, diffuse);
          }
        }
      return { technique, problem, off, brightest, labels: tiles.map(({ label }) => label) };
    });
  });
  for (const { technique, problem, off, brightest, labels } of rows) {
    expect.soft(problem, technique).toBeNull();
    expect.soft(brightest, technique).toBeGreaterThan(1);
    // half floats
    expect.soft(off, technique).toBeLessThan(0.002);
    expect.soft(labels[0], technique).toBe('Diffuse light');
    expect.soft(labels, technique).toHaveLength(4);
  }
});

for (const kind of ['PCFShadowMap', 'VSMShadowMap'] as const) {
  test(`the view of the shadow atlas has the map of each light at its distance: ${kind} ${kind === 'VSMShadowMap' ? '@verify' : ''}`, async ({
    benchPage: page,
  }) => {
    const rows = await page.evaluate(
      async ([kind, count]) => {
        const { Bench, compareImages, drawn, farol, three } = window.testPage;
        await farol.FarolRenderer.preload();
        const size = 128;
        const bench = new Bench(size, size);
        bench.webgl.shadowMap.enabled = true;
        bench.webgl.shadowMap.type = three[kind];
        const material = new three.MeshLambertMaterial({ side: three.DoubleSide });
        const floor = new three.Mesh(new three.PlaneGeometry(20, 20), material);
        floor.rotation.x = -Math.PI / 2;
        floor.castShadow = floor.receiveShadow = true;
        const spot = new three.SpotLight(0xffffff, 20, 9, 0.5);
        spot.position.set(0, 4, 0);
        spot.target.position.set(0, 0, 0);
        const point = new three.PointLight(0xffffff, 20, 9);
        point.position.set(2, 3, 0);
        const sun = new three.DirectionalLight(0xffffff, 1);
        sun.position.set(0, 10, 0);
        const lights = [spot, point, sun];
        for (const light of lights) {
          light.castShadow = true;
          light.shadow.mapSize.set(256, 256);
          Object.assign(light.shadow.camera, { near: 0.5, far: 20 });
        }
        const scene = new three.Scene().add(floor, ...lights, spot.target);
        const camera = new three.PerspectiveCamera(60, 1, 0.1, 100);
        camera.position.set(0, 5, 8);
        camera.lookAt(0, 0, 0);
        return drawn.slice(0, count).map((technique) => {
          bench.farol.view = 'final';
          const before = bench.byTechnique(technique, scene, camera);
          bench.farol.view = 'shadow-atlas';
          const { data } = bench.byTechnique(technique, scene, camera);
          const { problem, tiles } = bench.farol.info.view!;
          const middles = tiles.map(({ light, number, count, near, far, x, y, width, height }) => {
            const pixel = Math.floor((1 - y - height / 2) * size) * size + Math.floor((x + width / 2) * size);
            return { light: lights.indexOf(light as never), number, count, near, far, value: data[4 * pixel] };
          });
          bench.farol.view = 'final';
          const after = compareImages(before, bench.byTechnique(technique, scene, camera)).largest;
          return { technique, problem, middles, after };
        });
      },
      [kind, byExtent({ slice: 1, verify: 10 })] as const,
    );
    const logarithm = (distance: number, near: number, far: number) => Math.log(distance / near) / Math.log(far / near);
    for (const { technique, problem, middles, after } of rows) {
      expect.soft(problem, technique).toBeNull();
      expect.soft(after, `${technique}: the picture after the view`).toBe(0);
      // as in three, point lights have no variance shadow maps
      const cube = kind === 'VSMShadowMap' ? [] : [1, 1, 1, 1, 1, 1];
      expect.soft(middles.map(({ light }) => light).toSorted(), technique).toEqual([0, ...cube, 2]);
      const [spot] = middles.filter(({ light }) => light === 0);
      expect.soft(Math.abs(spot.value - logarithm(4, spot.near, spot.far)), `${technique}, spot`).toBeLessThan(0.02);
      const [sun] = middles.filter(({ light }) => light === 2);
      expect.soft(Math.abs(sun.value - (10 - sun.near) / (sun.far - sun.near)), `${technique}, sun`).toBeLessThan(0.01);
      // the face that looks down
      const downs = middles.filter(({ light, number }) => light === 1 && number === 4);
      expect.soft(downs, technique).toHaveLength(cube.length / 6);
      for (const { value, near, far, count } of downs) {
        expect.soft(Math.abs(value - logarithm(3, near, far)), `${technique}, point`).toBeLessThan(0.02);
        expect.soft(count, technique).toBe(6);
      }
    }
  });
}

test('views of fog are its light, its share, and its slices, by every technique @verify', async ({
  benchPage: page,
}) => {
  const rows = await page.evaluate(async () => {
    const { Bench, drawn, effects, farol, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const [width, height] = [64, 48];
    const bench = new Bench(width, height);
    const material = new three.MeshBasicMaterial({ color: 0 });
    const near = new three.Mesh(new three.PlaneGeometry(4, 20), material);
    near.position.set(-2, 0, -5);
    const far = new three.Mesh(new three.PlaneGeometry(80, 80), material);
    far.position.set(0, 0, -15);
    const scene = new three.Scene().add(near, far, new three.AmbientLight(0xffffff, 1));
    const camera = new three.PerspectiveCamera(60, width / height, 0.1, 100);
    const fog = new effects.VolumetricFog();
    Object.assign(fog, { density: 0.1, distance: 20, frames: 1, time: 0, froxels: [16, 12, 64] });
    bench.farol.effects = [fog];
    return drawn.map((technique) => {
      const draw = (view: (typeof farol.views)[number], color = 0) => {
        bench.farol.view = view;
        material.color.setScalar(color);
        return bench.byTechnique(technique, scene, camera).data;
      };
      const [black, white] = [draw('final'), draw('final', 1)];
      const light = draw('fog-light');
      const share = draw('fog-transmittance');
      let [lightOff, shareOff, least, most] = [0, 0, 1, 0];
      for (let i = 0; i < black.length; i += 4) {
        lightOff = Math.max(lightOff, Math.abs(light[i] - black[i]));
        shareOff = Math.max(shareOff, Math.abs(share[i] - (white[i] - black[i])));
        least = Math.min(least, share[i]);
        most = Math.max(most, share[i]);
      }
      const froxels = draw('froxels');
      const { tiles, problem } = bench.farol.info.view!;
      const values = tiles.map(({ x, y, width: w, height: h }) => {
        const pixel = Math.floor((1 - y - h / 2) * height) * width + Math.floor((x + w / 2) * width);
        return froxels[4 * pixel];
      });
      const edges = tiles.map((tile) => [tile.number, tile.near, tile.far]);
      return { technique, lightOff, shareOff, least, most, problem, values, edges };
    });
  });
  expect(rows).toHaveLength(10);
  for (const { technique, lightOff, shareOff, least, most, problem, values, edges } of rows) {
    expect.soft(problem, technique).toBeNull();
    expect.soft(lightOff, technique).toBeLessThan(0.002);
    expect.soft(shareOff, technique).toBeLessThan(0.005);
    // along the view by 5 m and 15 m, and a little more beside the middle
    expect.soft(Math.abs(most - Math.exp(-0.5)), `${technique}: ${most}`).toBeLessThan(0.03);
    expect.soft(least, technique).toBeLessThan(Math.exp(-1.5));
    expect.soft(values, technique).toHaveLength(64);
    // ambient light of irradiance 1 is a radiance of 1 / π
    for (const value of values) expect.soft(Math.abs(value - 1 / Math.PI), technique).toBeLessThan(0.003);
    expect.soft(edges[0].slice(0, 2), technique).toEqual([1, 0]);
    expect.soft(edges[63][2], technique).toBeCloseTo(20, 3);
    for (let i = 1; i < 64; i++) expect.soft(edges[i][1], technique).toBeCloseTo(edges[i - 1][2], 6);
  }
});
