import type * as THREE from 'three';
import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

// Shadow maps that are kept from frame to frame: drawn anew when, and only when, stock three shows another picture.

test('kept maps are drawn anew for what changes without a new version of anything; one that may not be stays where it was', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { compareImages, floorScene, three } = window.testPage;
    const { bench, scene, floor, box: cube, point, camera } = floorScene();
    const { Mesh, MeshStandardMaterial: Standard, PlaneGeometry, Scene } = three;
    const checks = new three.DataTexture(new Uint8Array(16).fill(255).fill(0, 7, 12), 2, 2);
    checks.wrapS = checks.wrapT = three.RepeatWrapping;
    checks.needsUpdate = true;
    const cut = new Standard({ map: checks, alphaTest: 0.5, side: three.DoubleSide });
    const bent = new Standard({ displacementMap: checks.clone(), displacementScale: 1, side: three.DoubleSide });
    const parts = [new Standard(), new Standard()];
    const things = [
      cube,
      new Mesh(new PlaneGeometry(2, 2), cut),
      new Mesh(new PlaneGeometry(2, 2, 8, 8), bent),
      new Mesh(cube.geometry.clone(), parts),
    ] as const;
    things.forEach((thing, i) => {
      thing.position.set(2 * i - 3, 1, 0);
      thing.castShadow = true;
    });
    const shape = new three.BoxGeometry(0.5, 0.5, 0.5);
    shape.morphAttributes.position = [new three.BoxGeometry(4, 2, 0.5).attributes.position as THREE.BufferAttribute];
    const instances = new three.InstancedMesh(shape, new Standard(), 1);
    const morph = (influence: number) => {
      instances.setMorphAt(0, Object.assign(new Mesh(shape), { morphTargetInfluences: [influence] }));
      instances.morphTexture!.needsUpdate = true;
    };
    instances.setMatrixAt(0, new three.Matrix4());
    instances.position.set(0, 1, 1.5);
    instances.castShadow = true;
    morph(0);
    const spot = new three.SpotLight(0xffffff, 120, 20, 0.9);
    spot.position.set(-3, 6, 2);
    spot.shadow.bias = -0.005;
    spot.castShadow = true;
    scene.add(...things, instances, spot, new three.HemisphereLight());
    const other = new Scene().add(floor.clone(), things[1].clone());
    let shown = scene;
    let before = bench.stock(scene, camera);
    const step = (name: string, change: () => void) => {
      change();
      const image = bench.byTechnique('forward-single-pass', shown, camera);
      bench.byTechnique('forward-single-pass', shown, camera);
      const { drawn } = bench.farol.info.shadows;
      const stock = bench.stock(shown, camera);
      const changed = compareImages(before, stock).psnr;
      before = stock;
      return { name, changed, drawn, psnr: compareImages(stock, image).psnr };
    };
    const box = cube.geometry;
    step('first', () => {});
    bench.byTechnique('forward-single-pass', other, camera);
    return [
      step('another index', () => box.setIndex(new three.BufferAttribute(new Uint16Array([16, 17, 18]), 1))),
      step('other positions', () =>
        box.setAttribute(
          'position',
          new three.BufferAttribute(
            box.attributes.position.array.map((x) => 0.6 * x),
            3,
          ),
        ),
      ),
      step('holes move', () => checks.offset.set(0.25, 0.25)),
      step('texture coordinates', () => {
        const { uv } = things[1].geometry.attributes;
        for (let i = 0; i < uv.count; i++) uv.setX(i, 3 * uv.getX(i));
        uv.needsUpdate = true;
      }),
      step('displacement moves', () => bent.displacementMap!.offset.set(0.5, 0)),
      step('groups', () => things[3].geometry.groups.splice(0, 3)),
      step('a morph of instances', () => morph(1)),
      step('in another scene', () => (shown = other.add(point, spot))),
      step('back', () => (shown = scene.add(point, spot))),
      step('a light moves whose map may not be drawn', () => {
        point.shadow.autoUpdate = false;
        point.position.x = 2;
      }),
      step('variance', () => {
        bench.webgl.shadowMap.type = three.VSMShadowMap;
        point.castShadow = false;
      }),
      step('more blur', () => Object.assign(spot.shadow, { radius: 20, blurSamples: 20 })),
    ];
  });
  const measured = [59, 59, 59, 59, 54.7, 54.7, 65.5, 117, 65.5, 62.2, 126, 114];
  expect(seen.length).toBe(measured.length);
  for (const [i, { name, changed, drawn, psnr }] of seen.entries()) {
    expect(changed, `${name} is to be seen`).toBeLessThan(45);
    expectAsMeasured(psnr, measured[i], name);
    expect(drawn, `${name}: once`).toBe(0);
  }
});

test('a mirror that stock three draws inside the frame shows the shadows of the frame @verify', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, shadowScene, three } = window.testPage;
    const [width, height] = [128, 96];
    const bench = new Bench(width, height);
    const { webgl } = bench;
    const { shadowMap } = webgl;
    shadowMap.enabled = true;
    const { scene, camera, lights } = shadowScene(width, height, { caster: 'mixed' });
    const mirrored = camera.clone();
    mirrored.position.z += 1;
    const target = new three.WebGLRenderTarget(width, height);
    const mirror = new three.Mesh(new three.PlaneGeometry(4, 3), new three.MeshBasicMaterial({ map: target.texture }));
    mirror.position.set(0, 2, -1);
    scene.add(mirror);
    // as three's Reflector has it
    mirror.onBeforeRender = () => {
      const { autoUpdate } = shadowMap;
      const own = webgl.getRenderTarget();
      mirror.visible = shadowMap.autoUpdate = false;
      webgl.setRenderTarget(target);
      webgl.render(scene, mirrored);
      webgl.setRenderTarget(own);
      mirror.visible = true;
      shadowMap.autoUpdate = autoUpdate;
    };
    const techniques = ['forward-single-pass', 'deferred'] as const;
    const images = techniques.map((technique) => bench.byTechnique(technique, scene, camera));
    scene.position.x = 0.5;
    const moved = techniques.map((technique) => bench.byTechnique(technique, scene, camera));
    const stockMoved = bench.stock(scene, camera);
    scene.position.x = 0;
    const stock = bench.stock(scene, camera);
    for (const light of lights) light.castShadow = false;
    return {
      matters: compareImages(stock, bench.stock(scene, camera)).psnr,
      pairs: [
        ...images.map((image) => compareImages(stock, image)),
        ...moved.map((one) => compareImages(stockMoved, one)),
      ],
    };
  });
  expect(seen.matters, 'shadows are to be seen').toBeLessThan(32);
  const measured = [59.3, 58.3, 67.5, 64.5];
  for (const [i, { psnr }] of seen.pairs.entries()) expectAsMeasured(psnr, measured[i], `picture ${i}`);
});

test('where point lights alone cast shadows, one that leaves its map is drawn as in stock three @verify', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { compareImages, floorScene } = window.testPage;
    const { bench, scene, point, camera } = floorScene();
    const before = bench.stock(scene, camera);
    const names = ['clustered-deferred', 'tiled-deferred', 'deferred', 'clustered-forward'] as const;
    for (const name of names) bench.byTechnique(name, scene, camera);
    point.shadow.autoUpdate = false;
    point.position.x = 2;
    const stock = bench.stock(scene, camera);
    return {
      changed: compareImages(before, stock).psnr,
      left: names.map((name) => [name, compareImages(stock, bench.byTechnique(name, scene, camera)).psnr] as const),
    };
  });
  expect(seen.changed).toBeLessThan(45);
  for (const [name, psnr] of seen.left) expectAsMeasured(psnr, name === 'clustered-forward' ? 108.8 : 62.5, name);
});
