import * as farol from '@farol/renderer';
import * as three from 'three';

/** What an empty page offers to a browser test that builds its own scene: three and the renderer, whole. */
export interface TestPage {
  three: typeof three;
  farol: typeof farol;
}

declare global {
  interface Window {
    testPage: TestPage;
  }
}

window.testPage = { three, farol };
