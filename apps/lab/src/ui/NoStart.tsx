import { t } from '@farol/editing';
/** Page in place of the Lab in a browser that cannot measure. */
export function NoStart({ problem }: { problem: string }) {
  return (
    <main class="no-start">
      <h1>{t('Farol Lab cannot measure here')}</h1>
      <p role="alert">{problem}</p>
    </main>
  );
}

/** Reason why the browser cannot draw with WebGL 2, with the remedy, one sentence; null if it can. */
export function webglProblem(): string | null {
  if (typeof WebGL2RenderingContext === 'undefined') {
    return t('This browser has no WebGL 2: use Chrome, Edge or Firefox of the last two years, or Safari 17 or newer.');
  }
  if (!document.createElement('canvas').getContext('webgl2')) {
    return t(
      'WebGL 2 is switched off here: switch hardware acceleration on in the browser’s settings, or update the graphics driver, then load the page again.',
    );
  }
  return null;
}
