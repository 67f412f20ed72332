declare global {
  interface Window {
    /** Console errors, errors of the page and lost WebGL contexts; left by {@link problemScript}. */
    problems: string[] | undefined;
  }
}

/** Keeps what goes wrong in a page: not every driver tells of the console. This function runs first in the page. */
function keepProblems(): void {
  const problems: string[] = (window.problems = []);
  const said = (value: unknown): string => (value instanceof Error ? `${value.message} ${value.stack}` : String(value));
  const { error } = console;
  console.error = (...values: unknown[]) => {
    problems.push(`console error: ${values.map(said).join(' ')}`);
    error(...values);
  };
  addEventListener('error', (event) => problems.push(`page error: ${said(event.error ?? event.message)}`));
  addEventListener('unhandledrejection', ({ reason }) => problems.push(`rejection: ${said(reason)}`));
  addEventListener('webglcontextlost', () => problems.push('a WebGL context was lost'), { capture: true });
}

export const problemScript = `(${keepProblems})()`;
