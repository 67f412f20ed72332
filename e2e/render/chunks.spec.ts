import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';
import type { Difference } from '../support/images';
import { inTurn } from '../support/parts';

interface Result extends Difference {
  readonly name: string;
  readonly technique: string;
}

/** Changes of `ShaderChunk`: what is looked for in a chunk, and what is put there. */
const changes = {
  'soft shadows': ['shadowmap_pars_fragment', /shadowRadius \* texelSize/g, '9.0 * shadowRadius * texelSize'],
  fog: ['fog_fragment', /$/, '\ngl_FragColor.rgb = mix(gl_FragColor.rgb, vec3(0.6, 0.2, 0.1), 0.3);'],
  'fog of another depth': ['fog_vertex', /vFogDepth = - mvPosition\.z/, 'vFogDepth = 2.0 * abs(mvPosition.x)'],
  'tone mapping': ['tonemapping_pars_fragment', /vec3 CustomToneMapping\( vec3 color \) \{ return color; \}/, 'vec3 CustomToneMapping( vec3 color ) { return sqrt(color.gbr) * 0.7; }'],
  'lobes of lights': ['lights_physical_pars_fragment', /vec3 irradiance = dotNL \* directLight\.color;/, 'vec3 irradiance = vec3(0.6, 1.0, 0.4) * dotNL * directLight.color;'],
  'end of lights': ['lights_fragment_end', /^/, 'reflectedLight.directDiffuse *= vec3(0.5, 1.0, 1.5);\n'],
  'first of vertices': ['begin_vertex', /$/, '\ntransformed.y *= 1.4;'],
  'projection of vertices': ['project_vertex', /$/, '\ngl_Position.y += 0.15 * gl_Position.x;'],
  'last colour': ['opaque_fragment', /$/, '\ngl_FragColor.rgb = gl_FragColor.bgr;'],
  'light functions': ['lights_pars_begin', /light\.color = pointLight\.color;/, 'light.color = pointLight.color.brg;'],
  'light loops': ['lights_fragment_begin', /RE_Direct\( directLight, geometryPosition, geometryNormal/g, 'directLight.color *= vec3(1.0, 0.4, 0.7); RE_Direct( directLight, geometryPosition, geometryNormal'],
} as const; // prettier-ignore

/** Those whose shadows three itself draws; Farol's maps differ by a texel at edges, and by their 16 bits. */
const BY_THREE = /^(soft shadows|first of vertices|projection of vertices|light functions|light loops)$/;
const SHADOWS = { largest: Infinity, psnr: 45 };

test('what a page changes in ShaderChunk is in the picture of every technique, and gone when it is undone', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(
    ({ texts, undone }): Result[] => {
      const {
        Bench,
        chunkScene,
        compareImages,
        drawn,
        techniqueInTurn,
        techniquesInTurn,
        three: THREE,
      } = window.testPage;
      const bench = new Bench(96, 64);
      // three maps tones for the canvas, and for what stands in for it
      Object.assign(bench.target, { isXRRenderTarget: true });
      bench.target.texture.colorSpace = THREE.LinearSRGBColorSpace;
      bench.farol.inferredScale = 1;
      const { webgl } = bench;
      webgl.toneMapping = THREE.CustomToneMapping;
      webgl.shadowMap.enabled = true;
      const { scene, camera } = chunkScene(96, 64);
      /** three compiles a program anew when no material holds it any more. */
      const reset = () =>
        scene.traverse((object) => ((object as import('three').Mesh).material as import('three').Material)?.dispose());
      const plain = bench.stock(scene, camera);
      const chunks = THREE.ShaderChunk as Record<string, string>;
      return Object.entries(texts).flatMap(([name, [chunk, source, flags, to]], index) => {
        const own = chunks[chunk];
        chunks[chunk] = own.replace(new RegExp(source, flags), to);
        if (chunks[chunk] === own) throw new Error(`${name}: ${chunk} is as it was`);
        reset();
        const wanted = bench.stock(scene, camera);
        if (compareImages(plain, wanted).psnr > 45) throw new Error(`${name}: does not show`);
        // one by all techniques (in the slice by one of each family), the rest by two or three in turn
        const turn =
          name === 'light loops'
            ? techniquesInTurn(0, drawn)
            : techniqueInTurn(
                index,
                drawn.filter((_, i) => (i + index) % 4 === 0),
              );
        const found = turn.map((technique) => ({
          name,
          technique,
          ...compareImages(wanted, bench.byTechnique(technique, scene, camera)),
        }));
        chunks[chunk] = own;
        reset();
        if (!undone.includes(name)) return found;
        const technique = turn[0];
        const again = compareImages(plain, bench.byTechnique(technique, scene, camera));
        return [...found, { name: `${name}, undone`, technique, ...again }];
      });
    },
    {
      texts: Object.fromEntries(
        inTurn(Object.entries(changes), 0, 2).map(([name, [chunk, from, to]]) => [
          name,
          [chunk, from.source, from.flags, to] as const,
        ]),
      ),
      undone: inTurn(Object.keys(changes), 2, 5),
    },
  );
  for (const { name, technique, ...difference } of results)
    expect.soft(() => checkAgreement(technique, difference, name, BY_THREE.test(name) ? {} : SHADOWS)).not.toThrow();
});

/** Changes of `ShaderLib`: a shader of it, which stage, what is looked for and what is put after it. */
const shaders = [
  ['physical', 'fragmentShader', '#include <opaque_fragment>', 'gl_FragColor.rgb = gl_FragColor.bgr;'],
  ['physical', 'vertexShader', '#include <project_vertex>', 'gl_Position.y += 0.3 * gl_Position.x;'],
  ['phong', 'vertexShader', '#include <project_vertex>', 'gl_Position.y += 0.3 * gl_Position.x;'],
  ['lambert', 'fragmentShader', '#include <opaque_fragment>', 'gl_FragColor.rgb = gl_FragColor.bgr;'],
  ['depth', 'vertexShader', '#include <begin_vertex>', 'transformed.y *= 2.5;'],
] as const;

test('what a page changes in ShaderLib is in the picture of every technique, and gone when it is undone @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate((shaders): Result[] => {
    const { Bench, chunkScene, compareImages, drawn, three: THREE } = window.testPage;
    const all: Result[] = [];
    for (const [shader, stage, from, more] of shaders) {
      const bench = new Bench(64, 44);
      bench.farol.inferredScale = 1;
      bench.webgl.shadowMap.enabled = true;
      const { scene, camera, lights } = chunkScene(64, 44);
      /** three compiles anew when no material holds a program any more; what draws shadow maps is the light's. */
      const reset = () => {
        scene.traverse((object) =>
          ((object as import('three').Mesh).material as import('three').Material)?.dispose(),
        );
        for (const { shadow } of lights as import('three').SpotLight[]) shadow.needsUpdate = true;
      };
      const library = THREE.ShaderLib[shader];
      const own = library[stage];
      // before anything is drawn: programs of three's own depth material are for good
      library[stage] = own.replace(from, `${from}\n${more}`);
      const wanted = bench.stock(scene, camera);
      for (const technique of drawn)
        all.push({ name: `${shader}, ${stage}`, technique, ...compareImages(wanted, bench.byTechnique(technique, scene, camera)) });
      library[stage] = own;
      if (shader !== 'depth') {
        reset();
        const plain = bench.stock(scene, camera);
        if (compareImages(plain, wanted).psnr > 45) throw new Error(`${shader}: does not show`);
        for (const technique of drawn.slice(0, 3))
          all.push({ name: `${shader}, ${stage}, undone`, technique, ...compareImages(plain, bench.byTechnique(technique, scene, camera)) });
      }
      bench.webgl.dispose();
    }
    return all;
  }, shaders); // prettier-ignore
  for (const { name, technique, ...difference } of results)
    expect
      .soft(() => checkAgreement(technique, difference, name, technique === 'inferred' ? {} : SHADOWS))
      .not.toThrow();
});

test("three's cascaded shadow maps come out as by stock three, in every technique, with fading edges too", async ({
  benchPage: page,
}) => {
  const results = await page.evaluate((): Result[] => {
    const { Bench, addons, chunkScene, compareImages, drawn, techniquesInTurn, three: THREE } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const { scene, camera, lights } = chunkScene(96, 64);
    scene.remove(...lights);
    const chunks = { ...THREE.ShaderChunk };
    const csm = new addons.CSM({
      parent: scene,
      camera,
      cascades: 3,
      maxFar: 20,
      shadowMapSize: 128,
      lightDirection: new THREE.Vector3(-1, -2, -1).normalize(),
      lightMargin: 20,
      shadowBias: -0.004,
    });
    scene.traverse((object) => {
      const { material } = object as import('three').Mesh;
      if (material) csm.setupMaterial(material as import('three').Material);
    });
    const results: Result[] = [];
    for (const fade of [false, true]) {
      csm.fade = fade;
      csm.updateFrustums();
      csm.update();
      const wanted = bench.stock(scene, camera);
      for (const technique of techniquesInTurn(4, drawn)) {
        const difference = compareImages(wanted, bench.byTechnique(technique, scene, camera));
        results.push({ name: fade ? 'CSM, fading' : 'CSM', technique, ...difference });
      }
    }
    csm.remove();
    csm.dispose();
    Object.assign(THREE.ShaderChunk, chunks);
    return results;
  });
  for (const { name, technique, ...difference } of results)
    expect.soft(() => checkAgreement(technique, difference, name)).not.toThrow();
});
