import { render } from 'preact';
import { LabPage } from './ui/LabPage';
import { NoStart } from './ui/NoStart';
import { applyTheme, storedTheme } from './ui/support/theme';
import { webglProblem } from './ui/support/webglProblem';
import './style.css';

applyTheme(storedTheme());
const place = document.getElementById('app')!;
place.replaceChildren();
const problem = webglProblem();
render(problem ? <NoStart problem={problem} /> : <LabPage />, place);
