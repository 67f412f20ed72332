import { render } from 'preact';
import { installLabHandle } from './labHandle';
import { LabPage } from './ui/LabPage';
import { NoStart } from './ui/NoStart';
import { applyTheme, storedTheme } from './ui/support/theme';
import { webglProblem } from './ui/support/webglProblem';
import './style.css';

installLabHandle();
// npm run bench measures without the page
if (!new URLSearchParams(location.search).has('headless')) showPage();

function showPage(): void {
  applyTheme(storedTheme());
  const place = document.getElementById('app')!;
  place.replaceChildren();
  const problem = webglProblem();
  render(problem ? <NoStart problem={problem} /> : <LabPage />, place);
}
