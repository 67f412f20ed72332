import * as farol from '@farol/renderer';
import * as authoring from '@farol/renderer/authoring';
import * as ambientOcclusion from '@farol/renderer/ambient-occlusion';
import * as antialiasing from '@farol/renderer/antialiasing';
import * as three from 'three';
import { CSM } from 'three/addons/csm/CSM.js';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import { ShadowMapViewer } from 'three/addons/utils/ShadowMapViewer.js';
import { setLightOptions } from '@farol/renderer/light-options';
import * as lightFields from '@farol/renderer/light-field';
import * as decals from '@farol/renderer/decals';
import * as particles from '@farol/renderer/particles';
import * as lightProfiles from '@farol/renderer/light-profiles';
import * as surfaces from '@farol/renderer/surfaces';
import * as transparency from '@farol/renderer/transparency';
import * as volumetricFog from '@farol/renderer/volumetric-fog';
import { compareImages, isFlat } from '../support/images';
import { alphaBench, alphaScene } from './alphaScene';
import { DistanceFade } from './authoring/DistanceFade';
import { nearFirst } from './authoring/nearFirst';
import { Bench } from './Bench';
import { boundsScene } from './boundsScene';
import { breakFrames, brokenScene, faultsOf, messageOf } from './brokenFrames';
import { devices } from './devices';
import { drawDevice, drawQuality } from './drawDevice';
import { countGpuObjects } from './gpuObjects';
import { loseContexts } from './loseContexts';
import { checkedMap } from './checkedMap';
import { chunkScene } from './chunkScene';
import { edgeScene } from './edgeScene';
import { hostSnapshot } from './hostSnapshot';
import { LateCase } from './lateCases';
import { CELL, lineSheet } from './lineSheet';
import { FogScene } from './fogScene';
import { floorScene } from './floorScene';
import { fewMeshes, materialScene } from './materialScene';
import { oneParticle } from './oneParticle';
import { privateScene } from './privateScene';
import { readTexels } from './readTexels';
import { supersampled } from './supersampled';
import { SURFACE, surfaceScene } from './surfaceScene';
import { shadowScene } from './shadowScene';
import { runSettings } from './matrix/runSettings';
import { enlargeSheet } from './matrix/enlargeSheet';
import { compareQualities, runSheet } from './matrix/runSheet';
import { settings } from './matrix/settings';
import { randomIn } from './random';
import { drawn, families, isSlice, techniqueInTurn, techniquesInTurn } from './techniquesInTurn';

/** An empty page for browser tests that build their own scenes: three and the renderer, whole. */
export interface TestPage {
  three: typeof three;
  farol: typeof farol;
  authoring: typeof authoring;
  surfaces: typeof surfaces;
  /** Exports of the effects' entries, such as `@farol/renderer/antialiasing`. */
  effects: typeof antialiasing &
    typeof ambientOcclusion &
    typeof transparency &
    typeof decals &
    typeof particles &
    typeof volumetricFog;
  FogScene: typeof FogScene;
  lightProfiles: typeof lightProfiles;
  lightFields: typeof lightFields;
  setLightOptions: typeof setLightOptions;
  /** Addons of three's. */
  addons: {
    CSM: typeof CSM;
    RectAreaLightUniformsLib: typeof RectAreaLightUniformsLib;
    ShadowMapViewer: typeof ShadowMapViewer;
  };
  /** A technique and an effect as somebody outside writes them. */
  outside: { readonly nearFirst: typeof nearFirst; readonly DistanceFade: typeof DistanceFade };
  alphaScene: typeof alphaScene;
  alphaBench: typeof alphaBench;
  boundsScene: typeof boundsScene;
  privateScene: typeof privateScene;
  materialScene: typeof materialScene;
  fewMeshes: typeof fewMeshes;
  chunkScene: typeof chunkScene;
  edgeScene: typeof edgeScene;
  floorScene: typeof floorScene;
  oneParticle: typeof oneParticle;
  lineSheet: typeof lineSheet;
  /** Pixels along a side of the squares of `lineSheet`. */
  CELL: typeof CELL;
  supersampled: typeof supersampled;
  surfaceScene: typeof surfaceScene;
  SURFACE: typeof SURFACE;
  checkedMap: typeof checkedMap;
  shadowScene: typeof shadowScene;
  brokenScene: typeof brokenScene;
  faultsOf: typeof faultsOf;
  breakFrames: typeof breakFrames;
  messageOf: typeof messageOf;
  /** Fetched by the tests that need it: it brings three's other renderer. */
  nodeScene(): Promise<typeof import('./nodeScene')>;
  /** Fetched by the tests that need it. */
  addonCases(): Promise<typeof import('./addonCases')>;
  /** Cases of node materials; fetched by the tests that need them. */
  nodeCases(): Promise<typeof import('./nodeCases')>;
  /** Fog in targets, by cameras and before transparent things; fetched by the tests that need it. */
  fogHosts(): Promise<typeof import('./fogHostCases')>;
  /** Lights in fog; fetched by the tests that need them. */
  fogCases(): Promise<typeof import('./fogLightCases')>;
  /** Fetched by the tests that need it. */
  bake(): Promise<typeof import('@farol/bake')>;
  /** Fetched by the tests that need it. */
  chance(): Promise<typeof import('./chance/runScenes')>;
  /** Fetched by the tests that need it. */
  budgetLoad(): Promise<typeof import('./budgetLoad')>;
  /** Fetched by the tests that need it. */
  pixelScenes(): Promise<typeof import('./pixelScenes')>;
  /** Fetched by the tests that need it: it brings the engine. */
  animatedScene(): Promise<typeof import('./animatedScene')>;
  /** Fetched by the tests that need it: it brings the demo scenes. */
  firstLitFrame(): Promise<typeof import('./firstLitFrame')>;
  hostSnapshot: typeof hostSnapshot;
  LateCase: typeof LateCase;
  enlargeSheet: typeof enlargeSheet;
  runSheet: typeof runSheet;
  compareQualities: typeof compareQualities;
  runSettings: typeof runSettings;
  settingNames: readonly string[];
  drawn: typeof drawn;
  isSlice: boolean;
  techniqueInTurn: typeof techniqueInTurn;
  families: typeof families;
  techniquesInTurn: typeof techniquesInTurn;
  Bench: typeof Bench;
  devices: typeof devices;
  drawDevice: typeof drawDevice;
  drawQuality: typeof drawQuality;
  readTexels: typeof readTexels;
  countGpuObjects: typeof countGpuObjects;
  loseContexts: typeof loseContexts;
  compareImages: typeof compareImages;
  isFlat: typeof isFlat;
  randomIn: typeof randomIn;
}

declare global {
  interface Window {
    testPage: TestPage;
  }
}

// what is drawn in the first frame of a test has its code, unless the test is of that
if (!location.search.includes('lazy')) await farol.FarolRenderer.preload();

window.testPage = {
  three,
  farol,
  authoring,
  surfaces,
  effects: { ...antialiasing, ...ambientOcclusion, ...transparency, ...decals, ...particles, ...volumetricFog },
  FogScene,
  lightProfiles,
  lightFields,
  setLightOptions,
  addons: { CSM, RectAreaLightUniformsLib, ShadowMapViewer },
  outside: { nearFirst, DistanceFade },
  alphaScene,
  alphaBench,
  boundsScene,
  privateScene,
  materialScene,
  fewMeshes,
  chunkScene,
  edgeScene,
  floorScene,
  oneParticle,
  lineSheet,
  CELL,
  supersampled,
  surfaceScene,
  SURFACE,
  checkedMap,
  shadowScene,
  brokenScene,
  faultsOf,
  breakFrames,
  messageOf,
  nodeScene: () => import('./nodeScene'),
  nodeCases: () => import('./nodeCases'),
  LateCase,
  addonCases: () => import('./addonCases'),
  fogHosts: () => import('./fogHostCases'),
  fogCases: () => import('./fogLightCases'),
  bake: () => import('@farol/bake'),
  chance: () => import('./chance/runScenes'),
  budgetLoad: () => import('./budgetLoad'),
  pixelScenes: () => import('./pixelScenes'),
  animatedScene: () => import('./animatedScene'),
  firstLitFrame: () => import('./firstLitFrame'),
  hostSnapshot,
  enlargeSheet,
  runSheet,
  compareQualities,
  runSettings,
  settingNames: Object.keys(settings),
  drawn,
  isSlice,
  techniqueInTurn,
  families,
  techniquesInTurn,
  Bench,
  devices,
  drawDevice,
  drawQuality,
  readTexels,
  countGpuObjects,
  loseContexts,
  compareImages,
  isFlat,
  randomIn,
};
