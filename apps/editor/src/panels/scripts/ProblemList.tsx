import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import type { ScriptProblem } from './scriptProblems';

/** Maximum number of problems listed; the others are counted. */
const MOST = 50;

/** Problems of a script by line; a click opens the line. */
export function ProblemList({ name, list }: { name: string; list: readonly ScriptProblem[] }): ReactNode {
  const editor = useEditor();
  return (
    <ul className="chunk-errors" aria-label={t('Errors')}>
      {list.slice(0, MOST).map(({ line, from, message }) => (
        <li key={`${line}:${from}:${message}`}>
          <button type="button" onClick={() => editor.openScript(name, line)}>
            {name}:{line}
          </button>
          <span>{message}</span>
        </li>
      ))}
      {list.length > MOST && <li>{t('And {count} more.', { count: list.length - MOST })}</li>}
    </ul>
  );
}
