import * as farol from '@farol/renderer';
import * as three from 'three';
import { compareImages, isFlat } from '../support/images';
import { Bench } from './Bench';
import { materialScene } from './materialScene';

/** What an empty page offers to a browser test that builds its own scene: three and the renderer, whole. */
export interface TestPage {
  three: typeof three;
  farol: typeof farol;
  materialScene: typeof materialScene;
  Bench: typeof Bench;
  compareImages: typeof compareImages;
  isFlat: typeof isFlat;
}

declare global {
  interface Window {
    testPage: TestPage;
  }
}

window.testPage = { three, farol, materialScene, Bench, compareImages, isFlat };
