import type { FarolRenderer } from '@farol/renderer';
import type { AttachLanguage } from './language/languages';

/** Options of `attachEditor`. */
export interface AttachOptions {
  /** FarolRenderer that draws the page, if any; the panels then show its technique, view and figures. */
  farol?: FarolRenderer;
  /** Parent element of the panels. Default the page's body: the panels lie over it at the right edge of the window. */
  container?: HTMLElement;
  /** Element on which the page's own controls listen. Default the canvas. */
  domElement?: HTMLElement;
  /**
   * Language of the panels, 'en' or 'es'. Default: the first of the browser's languages that is one of these, else
   * English.
   */
  language?: AttachLanguage;
  /**
   * Called after edits of the scene, for a page that draws on demand. Default: the editor draws a frame itself if the
   * page does not soon.
   */
  onChange?: () => void;
}
