import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('maps are kept until something that casts shadows changes in their reach, and the picture is never an old one', async ({
  benchPage: page,
}) => {
  const steps = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
    camera.position.set(0, 6, 12);
    camera.lookAt(0, 0, 0);
    const material = new three.MeshStandardMaterial();
    const floor = new three.Mesh(new three.PlaneGeometry(24, 12), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    const boxes = [-8, 0, 8].map((x) => {
      const box = new three.Mesh(new three.BoxGeometry(1, 1, 1), material);
      box.position.set(x, 1, 0);
      box.castShadow = true;
      return box;
    });
    // each light reaches its own box alone
    const lights = [-8, 0, 8].map((x, i) => {
      const light = i === 1 ? new three.SpotLight(0xffffff, 60, 6, 0.6) : new three.PointLight(0xffffff, 30, 6);
      light.position.set(x + 0.5, 4, 0);
      light.castShadow = true;
      light.shadow.mapSize.set(128, 128);
      light.shadow.bias = -0.005;
      if (light instanceof three.SpotLight) {
        light.target.position.set(x, 0, 0);
        scene.add(light.target);
      }
      return light;
    });
    scene.add(floor, ...boxes, ...lights);
    const step = (name: string, change: () => void) => {
      change();
      const image = bench.byTechnique('forward-single-pass', scene, camera);
      const { drawn, kept } = bench.farol.info.shadows;
      const { psnr, share } = compareImages(bench.stock(scene, camera), image);
      const hard = bench.webgl.shadowMap.type === three.BasicShadowMap;
      return { name, drawn, kept, hard, psnr, share };
    };
    const results = [
      step('first', () => {}),
      step('nothing changes', () => {}),
      step('the camera moves', () => camera.position.setX(0.5)),
      step('one box moves', () => boxes[0].position.setY(1.4)),
      step('its geometry', () => (boxes[0].geometry = new three.BoxGeometry(0.6, 0.6, 2))),
      step('its positions', () => {
        boxes[0].geometry.scale(1.8, 1, 0.4);
        boxes[0].geometry.computeBoundingSphere();
      }),
      step('it turns, in a light of its own', () => boxes[2].rotation.set(0, 1, 0.5)),
      step('it is hidden', () => (boxes[1].visible = false)),
      step('it comes back', () => (boxes[1].visible = true)),
      step('it casts none', () => (boxes[1].castShadow = false)),
      step('a light moves', () => (lights[1].position.x = 1)),
      step('bias alone', () => (lights[1].shadow.bias = -0.02)),
      step('so small a bias that depths must be finer', () => (lights[1].shadow.bias = -0.0001)),
      step('finer than it needs', () => (lights[1].shadow.bias = -0.02)),
      step('a larger map', () => lights[0].shadow.mapSize.set(256, 256)),
      step('another kind of map', () => (bench.webgl.shadowMap.type = three.BasicShadowMap)),
      step('stock three marked all materials for that', () => {}),
      step('at rest', () => {}),
    ];
    lights[0].shadow.autoUpdate = false;
    boxes[0].position.y = 2;
    bench.byTechnique('forward-single-pass', scene, camera);
    const frozen = bench.farol.info.shadows.drawn;
    lights[0].shadow.needsUpdate = true;
    bench.byTechnique('forward-single-pass', scene, camera);
    return { results, frozen, asked: bench.farol.info.shadows.drawn, consumed: !lights[0].shadow.needsUpdate };
  });
  expect(steps.results.map(({ name, drawn, kept }) => `${name}: ${drawn} drawn, ${kept} kept`)).toEqual([
    'first: 3 drawn, 0 kept',
    'nothing changes: 0 drawn, 3 kept',
    'the camera moves: 0 drawn, 3 kept',
    'one box moves: 1 drawn, 2 kept',
    'its geometry: 1 drawn, 2 kept',
    'its positions: 1 drawn, 2 kept',
    'it turns, in a light of its own: 1 drawn, 2 kept',
    'it is hidden: 1 drawn, 2 kept',
    'it comes back: 1 drawn, 2 kept',
    'it casts none: 1 drawn, 2 kept',
    'a light moves: 1 drawn, 2 kept',
    'bias alone: 0 drawn, 3 kept',
    'so small a bias that depths must be finer: 3 drawn, 0 kept',
    'finer than it needs: 0 drawn, 3 kept',
    'a larger map: 1 drawn, 2 kept',
    'another kind of map: 3 drawn, 0 kept',
    'stock three marked all materials for that: 2 drawn, 1 kept',
    'at rest: 0 drawn, 3 kept',
  ]);
  const measured: Record<string, number | undefined> = { 'one box moves': 46.2, 'a larger map': 52 };
  // at a hard edge one texel of a point light's map is several pixels of this small picture
  for (const { name, hard, psnr, share } of steps.results) {
    if (hard) expect(share, name).toBeLessThanOrEqual(0.005);
    else expectAsMeasured(psnr, measured[name] ?? 100, name);
  }
  expect(steps.frozen, 'autoUpdate false').toBe(0);
  expect(steps.asked, 'needsUpdate').toBe(1);
  expect(steps.consumed, 'needsUpdate is taken back').toBe(true);
});

test('while all moves, maps are drawn where they can be seen alone: as in stock three, also when the camera turns or all rests', async ({
  benchPage: page,
}) => {
  const frames = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
    const material = new three.MeshStandardMaterial();
    const floor = new three.Mesh(new three.PlaneGeometry(24, 24, 20, 20), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = floor.castShadow = true;
    const knots = [-5, 0, 5].map((x) => {
      const knot = new three.Mesh(new three.TorusKnotGeometry(0.8, 0.25, 96, 12), material);
      knot.position.set(x, 1.5, 0);
      knot.castShadow = knot.receiveShadow = true;
      // a mirrored one turns its triangles the other way
      if (x === 0) knot.scale.x = -1;
      return knot;
    });
    const point = new three.PointLight(0xffffff, 60, 14);
    const spot = new three.SpotLight(0xffffff, 200, 20, 0.5);
    const sun = new three.DirectionalLight(0xffffff, 0.5);
    sun.position.set(3, 8, 2);
    spot.target.position.set(4, 0, 0);
    for (const light of [point, spot, sun]) {
      light.castShadow = true;
      light.shadow.mapSize.set(256, 256);
      light.shadow.bias = -0.005;
      scene.add(light);
    }
    scene.add(floor, spot.target, ...knots);
    const look = (x: number, z: number) => {
      camera.position.set(0, 3, 9);
      camera.lookAt(x, 0, z);
    };
    const frame = (name: string, time: number | null) => {
      if (time !== null) {
        knots.forEach((knot, i) => (knot.rotation.y = time + i));
        point.position.set(-3 + time, 3, 1);
        spot.position.set(5, 6 - time, 2);
        sun.position.x = 3 + time;
      }
      const image = bench.byTechnique('forward-single-pass', scene, camera);
      const { drawn, texels } = bench.farol.info.shadows;
      return { name, drawn, texels, psnr: compareImages(bench.stock(scene, camera), image).psnr };
    };
    look(-4, 0);
    const results = [frame('first', 0), frame('moves', 0.1), frame('goes on', 0.2), frame('still goes on', 0.3)];
    look(4, 0);
    results.push(frame('the camera turns', 0.4), frame('rests', null));
    look(-8, -2);
    results.push(frame('the camera turns at rest', null), frame('all rests', null));
    for (let i = 0; i < 70; i++) bench.farol.render(scene, camera);
    results.push(frame('for long', null));
    look(8, 2);
    results.push(frame('and the camera turns', null));
    // what receives shadows is not where it was
    look(0, 0);
    floor.receiveShadow = false;
    results.push(frame('the floor receives none', 0.5), frame('all moves again', 0.6));
    knots[2].position.set(-1.5, 2.6, 1.8);
    results.push(frame('one jumps', 0.7));
    for (const { shadow } of [point, spot, sun]) shadow.normalBias = 0.8;
    results.push(frame('shadows are looked up beside what they fall on', 0.8));
    // merged until now
    const depths = new three.MeshDistanceMaterial();
    depths.onBeforeCompile = (shader) => {
      const { vertexShader } = shader;
      shader.vertexShader = vertexShader.replace('#include <begin_vertex>', 'vec3 transformed = 1.6 * position;');
    };
    knots[2].customDistanceMaterial = depths;
    results.push(frame('one has depths of its own', 0.9));
    return results;
  });
  const measured = [58.1, 76.1, 104, 101, 116, 116, 79.8, 79.8, 79.8, 62.7, 97, 104, 107, 106, 100];
  expect(frames.length).toBe(measured.length);
  for (const [i, { name, psnr }] of frames.entries()) expectAsMeasured(psnr, measured[i], name);
  const whole = 6 * 260 ** 2 + 2 * 256 ** 2;
  expect(frames[0].texels).toBe(whole);
  for (const { name, drawn, texels } of frames.slice(1, 5)) {
    expect(drawn, name).toBe(3);
    expect(texels, name).toBeLessThan(0.8 * whole);
    expect(texels, name).toBeGreaterThan(0);
  }
  expect(frames.slice(5, 10).map(({ drawn }) => drawn > 0)).toEqual([false, true, false, false, false]);
});

test('64 shadowed point and spot lights at once, also in an atlas too small for them; adding and removing compiles nothing', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, farol, three } = window.testPage;
    const bench = new Bench(128, 128);
    bench.webgl.shadowMap.enabled = true;
    const small = new farol.FarolRenderer(bench.webgl, { technique: 'tiled-deferred', shadowAtlasSize: 512 });
    const camera = new three.OrthographicCamera(-8, 8, 8, -8, 0.1, 20);
    camera.position.z = 10;
    const scene = new three.Scene();
    const material = new three.MeshLambertMaterial();
    const wall = new three.Mesh(new three.PlaneGeometry(16, 16), material);
    wall.receiveShadow = true;
    scene.add(wall);
    const lights: InstanceType<typeof three.PointLight | typeof three.SpotLight>[] = [];
    const boxes: InstanceType<typeof three.Mesh>[] = [];
    const geometry = new three.BoxGeometry(0.7, 0.7, 0.2);
    // a cell of 2 × 2 for each light, with a box before the middle of the wall
    for (let i = 0; i < 64; i++) {
      const [x, y] = [(i % 8) * 2 - 7, Math.floor(i / 8) * 2 - 7];
      const light = i % 2 ? new three.PointLight(0xffffff, 6, 3) : new three.SpotLight(0xffffff, 6, 3, 0.7);
      light.position.set(x, y, 1.6);
      light.castShadow = true;
      light.shadow.mapSize.set(64, 64);
      light.shadow.camera.near = 0.1;
      if (light instanceof three.SpotLight) {
        light.target.position.set(x, y, 0);
        scene.add(light.target);
      }
      const box = new three.Mesh(geometry, material);
      box.position.set(x, y, 0.6);
      box.castShadow = true;
      lights.push(light);
      boxes.push(box);
    }
    scene.add(...lights, ...boxes);
    // of the wall beside each box: one pixel in its shadow, one in the light
    const cells = (render: () => Float32Array) => {
      const data = render();
      return lights.map((_, i) => {
        const at = (dx: number) => data[4 * ((Math.floor(i / 8) * 16 + 8) * 128 + (i % 8) * 16 + 8 + dx)];
        return [at(4), at(7)];
      });
    };
    const draw = (renderer: InstanceType<typeof farol.FarolRenderer>) => () => {
      bench.webgl.setRenderTarget(bench.target);
      renderer.render(scene, camera);
      const data = new Float32Array(128 * 128 * 4);
      bench.webgl.readRenderTargetPixels(bench.target, 0, 0, 128, 128, data);
      bench.webgl.setRenderTarget(null);
      return data;
    };
    bench.farol.technique = 'tiled-deferred';
    const large = cells(draw(bench.farol));
    const drawnAtOnce = bench.farol.info.shadows.drawn;
    const reduced = cells(draw(small));
    const before = bench.programs;
    for (let i = 0; i < 64; i += 3) lights[i].castShadow = false;
    draw(bench.farol)();
    for (let i = 0; i < 64; i += 3) lights[i].castShadow = true;
    scene.remove(...lights.slice(0, 40), ...boxes.slice(10, 30));
    draw(bench.farol)();
    scene.add(...lights.slice(0, 40), ...boxes.slice(10, 30));
    const again = cells(draw(bench.farol));
    return { large, reduced, again, drawnAtOnce, compiled: bench.programs - before, bytes: small.info.shadows.bytes };
  });
  expect(seen.drawnAtOnce).toBe(64);
  for (const name of ['large', 'reduced', 'again'] as const) {
    seen[name].forEach(([shadowed, lit], i) => {
      expect(lit, `${name}: beside the shadow of light ${i}`).toBeGreaterThan(0.1);
      expect(shadowed, `${name}: in the shadow of light ${i}`).toBeLessThan((name === 'reduced' ? 0.6 : 0.3) * lit);
    });
  }
  expect(seen.bytes, 'bytes of the small atlas').toBe(512 * 512 * 5);
  expect(seen.compiled, 'programs compiled').toBe(0);
});

test('casters, lights and techniques that change back and forth compile nothing after the first time', async ({
  benchPage: page,
}) => {
  const compiled = await page.evaluate(() => {
    const { Bench, isSlice, shadowScene, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(48, 32);
    bench.webgl.shadowMap.enabled = true;
    const { scene, camera, lights } = shadowScene(48, 32, { caster: 'mixed', few: isSlice });
    const box = new three.Mesh(new three.BoxGeometry(), new three.MeshStandardMaterial());
    box.castShadow = true;
    const techniques = techniquesInTurn(0, ['forward', 'tiled-deferred', 'clustered-forward']);
    const added = new three.SpotLight(0xffffff, 20, 10, 0.5);
    added.castShadow = true;
    added.position.set(0, 4, 3);
    const round = () => {
      for (const technique of techniques) bench.byTechnique(technique, scene, camera);
    };
    scene.add(box);
    round();
    const before = bench.programs;
    scene.remove(box);
    round();
    for (const light of lights) light.castShadow = !light.castShadow;
    round();
    scene.add(box, added);
    round();
    for (const light of lights) light.castShadow = true;
    scene.remove(added);
    round();
    return bench.programs - before;
  });
  expect(compiled).toBe(0);
});

test("the host's lights, materials and renderer are as they were after shadows are drawn", async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, isSlice, shadowScene, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    const { scene, camera, lights } = shadowScene(64, 48, { caster: 'mixed', few: isSlice });
    const own = webgl.shadowMap.render;
    const snapshot = (all: boolean) => {
      const seen: unknown[] = [webgl.shadowMap.render === own, webgl.shadowMap.needsUpdate, webgl.shadowMap.type];
      // what three itself adds to objects when it first meets them is there after a frame of stock three
      if (all)
        scene.traverse((object) => {
          const { material } = object as InstanceType<typeof three.Mesh>;
          const one = material as InstanceType<typeof three.Material> | undefined;
          seen.push([
            object.uuid,
            object.layers.mask,
            object.visible,
            object.frustumCulled,
            Object.keys(object).join(),
          ]);
          if (one) seen.push([one.side, one.version, one.visible, Object.keys(one).join()]);
        });
      for (const light of lights) {
        const { shadow } = light as InstanceType<typeof three.SpotLight>;
        seen.push([shadow.mapPass, shadow.needsUpdate, shadow.mapSize.x, Object.keys(shadow)]);
        // what three changes of a shadow too is told by shadowProperties.spec.ts
        if (!all) continue;
        seen.push([shadow.map?.texture.uuid, shadow.matrix.elements.join()]);
        seen.push([shadow.camera.far, shadow.camera.matrixWorld.elements.join()]);
      }
      return JSON.stringify(seen);
    };
    const fresh = snapshot(false);
    bench.byTechnique('deferred', scene, camera);
    const afterFarol = snapshot(false);
    const first = bench.stock(scene, camera);
    const stocked = snapshot(true);
    bench.byTechnique('deferred', scene, camera);
    return {
      same: fresh === afterFarol,
      again: snapshot(true) === stocked,
      largest: compareImages(first, bench.stock(scene, camera)).largest,
    };
  });
  expect(results.same, 'before stock three made maps of its own').toBe(true);
  expect(results.again, 'after').toBe(true);
  expect(results.largest, 'stock three draws the same').toBe(0);
});

test('maps that are asked for once are drawn once, and again where they are gone; those never asked for are not drawn', async ({
  benchPage: page,
  watch,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, shadowScene } = window.testPage;
    const bench = new Bench(24, 16, { losesContext: true });
    const { webgl, farol } = bench;
    const { scene, camera, lights } = shadowScene(24, 16, { caster: 'spot', settings: { mapSize: 64 } });
    const draw = (): string => {
      bench.byTechnique('forward-single-pass', scene, camera);
      const { drawn, kept } = farol.info.shadows;
      return `${drawn} drawn, ${kept} kept`;
    };
    Object.assign(webgl.shadowMap, { enabled: true, autoUpdate: false });
    const steps = [`never asked for: ${draw()}`];
    webgl.shadowMap.needsUpdate = true;
    steps.push(`asked for: ${draw()}`, `after that: ${draw()}`);
    for (const light of lights) light.visible = false;
    // slots of lights that are not lit are kept for 600 frames
    for (let frame = 0; frame <= 601; frame++) draw();
    for (const light of lights) light.visible = true;
    steps.push(`lit again after long: ${draw()}`, `after that: ${draw()}`);
    await bench.loseContext();
    steps.push(`after a lost context: ${draw()}`, `after that: ${draw()}`);
    return steps;
  });
  expect(watch.forgive(/context was lost|CONTEXT_LOST_WEBGL/i)).toBeGreaterThan(0);
  expect(seen).toEqual([
    'never asked for: 0 drawn, 0 kept',
    'asked for: 2 drawn, 0 kept',
    'after that: 0 drawn, 2 kept',
    'lit again after long: 2 drawn, 0 kept',
    'after that: 0 drawn, 2 kept',
    'after a lost context: 2 drawn, 0 kept',
    'after that: 0 drawn, 2 kept',
  ]);
});
