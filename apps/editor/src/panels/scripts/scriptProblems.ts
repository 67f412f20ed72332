import { t } from '@farol/editing';
import type { DocumentScripts } from '../../model/DocumentScripts';
import type { ScriptDiagnostic } from '../../scripts/language/LanguageAnswers';

/** Something wrong with a script, whoever says so. */
export type ScriptProblem = Pick<ScriptDiagnostic, 'message' | 'line' | 'severity'> &
  Partial<Pick<ScriptDiagnostic, 'from' | 'to'>>;

/**
 * What is wrong with a script: what it threw while the scene played, why it cannot run, and what TypeScript finds. What two
 * say of one line is said once.
 */
export function problemsOf(
  name: string,
  scripts: Pick<DocumentScripts, 'errors' | 'failures'>,
  found: readonly ScriptDiagnostic[],
): readonly ScriptProblem[] {
  const problems: ScriptProblem[] = [];
  const failure = scripts.failures.get(name);
  if (failure) {
    const { line, component, object, message } = failure;
    const words = { component, object, reason: message };
    problems.push({ line, severity: 'error', message: t('{component} of {object} threw: {reason}', words) });
  }
  const error = scripts.errors.get(name);
  // of a text that cannot be read TypeScript says more
  const isTold = found.some(({ kind, line }) => kind === 'syntax' || line === error?.line);
  if (error && !isTold) problems.push({ line: error.line, severity: 'error', message: error.problem });
  return [...problems, ...found];
}
