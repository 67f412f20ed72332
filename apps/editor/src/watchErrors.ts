import { t } from '@farol/editing';
import { explainCompileError } from '@farol/renderer/microshaders';
import type { EditorApi } from './api/EditorApi';

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Logs errors of components, shaders and the page in the editor's console. */
export function watchErrors(editor: EditorApi): void {
  const { document, viewport, log } = editor;
  document.onComponentError = (component, error) => {
    const owner = component.isAttached ? component.gameObject.name : t('no object');
    const failure = document.scripts.note(component, error);
    if (failure) {
      const { component: type, script, line, message } = failure;
      const text = t(
        '{component} of {owner} is off until the scene stops, since it threw: {message} ({script}, line {line})',
        {
          ...{ component: type, owner, message, script, line },
        },
      );
      return log.add('error', 'script', text, { script, line });
    }
    log.add(
      'error',
      'component',
      t('{component} of {owner}: {reason}', { component: component.typeName, owner, reason: messageOf(error) }),
    );
  };
  /** Last error logged for each script. */
  const loggedErrors = new Map<string, string>();
  document.scripts.changed.subscribe(() => {
    const { errors } = document.scripts;
    for (const script of [...loggedErrors.keys()]) if (!errors.has(script)) loggedErrors.delete(script);
    for (const [script, { message, line }] of errors) {
      if (loggedErrors.get(script) === message) continue;
      loggedErrors.set(script, message);
      log.add('error', 'script', message, { script, line });
    }
  });
  viewport.webgl.debug.onShaderError = (gl, program, vertex, fragment) => {
    for (const shader of [vertex, fragment]) {
      if (gl.getShaderParameter(shader, gl.COMPILE_STATUS)) continue;
      const entries = explainCompileError(gl.getShaderInfoLog(shader) ?? '', gl.getShaderSource(shader) ?? '');
      for (const { chunk, line, message } of entries) {
        const place = chunk ? { chunk, line } : undefined;
        log.add(
          'error',
          'shader',
          t('{chunk}, line {line}: {message}', { chunk: chunk ?? t('shader'), line, message }),
          place,
        );
      }
    }
    const linked = (gl.getProgramInfoLog(program) ?? '').trim();
    editor.notices.show('error', `${t('A shader does not compile: see the console.')} ${linked}`.trim(), 'shader');
  };
  window.addEventListener('error', ({ message }) => log.add('error', 'page', message));
  window.addEventListener('unhandledrejection', ({ reason }) => log.add('error', 'page', messageOf(reason)));
}
