import type * as THREE from 'three';
import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('what a callback clears, and what it keeps of a material, is as by stock three in every technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
    const width = 64;
    const height = 48;
    const names = techniquesInTurn(3);
    type Scene = InstanceType<typeof three.Scene>;
    type Material = InstanceType<typeof three.MeshStandardMaterial>;
    const TINT = '#include <color_fragment>\ndiffuseColor.rgb *= tint;';
    const tinted = (text: string) => `uniform vec3 tint;\n${text.replace('#include <color_fragment>', TINT)}`;
    /** A ball in green glass, before a wall with another ball. */
    const stage = (material: InstanceType<typeof three.Material>) => {
      const scene = new three.Scene();
      scene.background = new three.Color(0x334455);
      const wall = new three.Mesh(new three.PlaneGeometry(2.4, 3), new three.MeshStandardMaterial());
      wall.position.z = -1;
      const ball = new three.Mesh(new three.SphereGeometry(0.7, 24, 16), material);
      ball.position.set(-0.6, 0, 0);
      const other = new three.Mesh(ball.geometry, new three.MeshPhongMaterial({ color: 0x6699ff }));
      other.position.set(0.8, 0.2, 0);
      const lamp = new three.PointLight(0xffffff, 12, 9);
      lamp.position.set(0.5, 1, 3);
      scene.add(wall, ball, other, lamp, new three.AmbientLight(0xffffff, 0.3));
      return { scene, ball };
    };
    const camera = new three.PerspectiveCamera(45, width / height, 0.1, 30);
    camera.position.z = 5;
    const standard = () => new three.MeshStandardMaterial({ color: 0xffaa66, roughness: 0.5 });
    const glass = (scene: Scene) => {
      const pane = new three.Mesh(
        new three.SphereGeometry(0.9, 24, 16),
        new three.MeshPhysicalMaterial({ transmission: 0.9, roughness: 0.1, thickness: 0.2 }),
      );
      pane.position.set(-0.6, 0, 0.3);
      scene.add(pane);
    };
    const runFirst = (webgl: THREE.WebGLRenderer, by: (webgl: THREE.WebGLRenderer) => void) => by(webgl);
    /** By name: makes a scene, and gives what is done before each frame. */
    const cases: Record<string, () => { scene: Scene; before?: (frame: number) => void }> = {
      'an overlay that clears depth first': () => {
        const { scene, ball } = stage(standard());
        ball.renderOrder = 9;
        ball.position.z = -3;
        ball.onBeforeRender = (webgl) => webgl.clearDepth();
        return { scene };
      },
      'an overlay without an order that clears depth first': () => {
        const { scene, ball } = stage(standard());
        ball.material = standard(); // the last that was made
        ball.position.z = -3;
        ball.onBeforeRender = (webgl) => webgl.clear(false, true, false);
        return { scene };
      },
      'a batch without an order that clears depth after its own callback': () => {
        const { scene, ball } = stage(standard());
        const batch = new three.BatchedMesh(1, 600, 3000, standard());
        batch.addInstance(batch.addGeometry(ball.geometry));
        batch.position.set(-0.6, 0, -3);
        ball.removeFromParent();
        const { onBeforeRender } = batch;
        batch.onBeforeRender = (webgl, ...rest) => {
          onBeforeRender.call(batch, webgl, ...rest);
          webgl.clearDepth();
        };
        scene.add(batch);
        return { scene };
      },
      'an overlay without an order that clears depth by another function': () => {
        const wipe = (webgl: THREE.WebGLRenderer) => webgl.clearDepth();
        const { scene, ball } = stage(standard());
        ball.material = standard();
        ball.position.z = -3;
        ball.onBeforeRender = (webgl) => runFirst(webgl, wipe);
        return { scene };
      },
      'a backdrop without an order that clears depth afterwards': () => {
        const { scene, ball } = stage(standard());
        ball.position.set(-1.2, 0, 2);
        ball.onAfterRender = (webgl) => webgl.clearDepth();
        return { scene };
      },
      'overlays in a group, of which the first clears depth': () => {
        const { scene } = stage(standard());
        const group = new three.Group();
        group.renderOrder = 2;
        for (let i = 0; i < 3; i++) {
          const box = new three.Mesh(new three.BoxGeometry(0.8, 0.8, 0.8), standard());
          box.position.set(i * 0.4 - 0.4, 0.2 * i, -3 - i);
          box.renderOrder = i;
          if (i === 0) box.onBeforeRender = (webgl) => webgl.clearDepth();
          group.add(box);
        }
        scene.add(group);
        return { scene };
      },
      'a backdrop that clears depth afterwards': () => {
        const { scene, ball } = stage(standard());
        ball.renderOrder = -1;
        ball.position.set(-1.2, 0, 2);
        ball.onAfterRender = (webgl) => webgl.clearDepth();
        return { scene };
      },
      'a material’s own fields in its onBeforeRender': () => {
        class Counted extends three.MeshStandardMaterial {
          #drawn = 0;
          override onBeforeRender() {
            this.#drawn++;
            this.color.setRGB(0.2, this.#drawn > 0 ? 1 : 0, 0.4);
          }
        }
        return { scene: stage(new Counted()).scene };
      },
      'uniforms that a page keeps, of a shader that several passes and techniques draw': () => {
        const material = standard();
        material.onBeforeCompile = (shader) => {
          shader.uniforms.tint = { value: new three.Color(0, 0, 0) };
          shader.fragmentShader = tinted(shader.fragmentShader);
          material.userData.shader = shader;
        };
        const { scene } = stage(material);
        glass(scene);
        return { scene, before: keep(material) };
      },
      'uniforms that are replaced in a lit ShaderMaterial': () => {
        const { phong } = three.ShaderLib;
        const material = new three.ShaderMaterial({
          lights: true,
          uniforms: three.UniformsUtils.merge([phong.uniforms, { tint: { value: new three.Color() } }]),
          vertexShader: phong.vertexShader,
          fragmentShader: tinted(phong.fragmentShader),
        });
        const before = (frame: number) => {
          material.uniforms.tint = { value: new three.Color().setHSL(frame / 3, 0.8, 0.5) };
        };
        return { scene: stage(material).scene, before };
      },
    };
    const keep = (material: Material) => (frame: number) => {
      const { shader } = material.userData as { shader?: { uniforms: Record<string, { value: unknown }> } };
      (shader?.uniforms.tint.value as InstanceType<typeof three.Color> | undefined)?.setHSL(frame / 3, 0.8, 0.5);
    };
    const results: { name: string; technique: string; difference: ReturnType<typeof compareImages> }[] = [];
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const reference = new Bench(width, height);
    for (const [name, make] of Object.entries(cases)) {
      const [byFarol, byThree] = [make(), make()];
      const frames = (draw: () => ReturnType<typeof bench.stock>, before?: (frame: number) => void) => {
        for (let i = 0; i < 2; i++) {
          before?.(i);
          draw();
        }
        before?.(2);
        return draw();
      };
      const wanted = frames(() => reference.stock(byThree.scene, camera), byThree.before);
      for (const technique of [...names, ...names.slice(0, 3)]) {
        const drawn = frames(() => bench.byTechnique(technique, byFarol.scene, camera), byFarol.before);
        results.push({ name, technique, difference: compareImages(wanted, drawn) });
      }
      // compiled by stock three when Farol has drawn it: both are right from then on
      const stock = frames(() => bench.stock(byFarol.scene, camera), byFarol.before);
      results.push({ name: `${name}, stock three in turn`, technique: 'forward', difference: compareImages(wanted, stock) });
      const again = frames(() => bench.byTechnique('deferred', byFarol.scene, camera), byFarol.before);
      results.push({ name: `${name}, after stock three`, technique: 'deferred', difference: compareImages(wanted, again) });
    }
    return results;
  }); // prettier-ignore
  for (const { name, technique, difference } of results) {
    const buffers = /deferred|light-prepass|auto/.test(technique);
    expect
      .soft(() => checkAgreement(technique, difference, name, buffers ? { psnr: 55, share: 0.001 } : {}), name)
      .not.toThrow();
  }
});

test('what callbacks of an object have three draw is drawn as by stock three, with a target of their own and without @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, brokenScene, compareImages, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { webgl } = bench;
    const { scene, camera, ball, glass } = brokenScene(64, 48);
    glass.removeFromParent();
    const inner = new three.Scene();
    inner.add(new three.Mesh(new three.BoxGeometry(), new three.MeshBasicMaterial({ color: 0xff0000 })));
    const eye = new three.PerspectiveCamera(50, 1, 0.1, 10);
    eye.position.z = 3;
    const target = new three.WebGLRenderTarget(16, 16);
    const acts: Record<string, () => void> = {
      // after three has cleared the picture so far
      cleared: () => webgl.render(inner, eye),
      'over it': () => {
        webgl.autoClear = false;
        webgl.render(inner, eye);
        webgl.autoClear = true;
      },
      aside: () => {
        const host = webgl.getRenderTarget();
        webgl.setRenderTarget(target);
        webgl.render(inner, eye);
        webgl.setRenderTarget(host);
      },
    };
    const others = window.testPage.techniquesInTurn(1, ['forward', 'clustered-deferred', 'light-prepass']);
    return (['onBeforeRender', 'onAfterRender'] as const).flatMap((when) =>
      Object.entries(acts).flatMap(([name, act]) => {
        ball[when] = act;
        const stock = bench.stock(scene, camera);
        const found = (['deferred', 'tiled-deferred', ...others] as const).map((technique) => ({
          name: `${when}, ${name}`,
          technique,
          difference: compareImages(stock, bench.byTechnique(technique, scene, camera)),
        }));
        ball[when] = three.Object3D.prototype[when];
        return found;
      }),
    );
  });
  for (const { name, technique, difference } of results)
    expect.soft(() => checkAgreement(technique, difference, name), name).not.toThrow();
});
