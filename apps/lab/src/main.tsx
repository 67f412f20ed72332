import { render } from 'preact';
import { LabPage } from './ui/LabPage';
import './style.css';

render(<LabPage />, document.getElementById('app')!);
