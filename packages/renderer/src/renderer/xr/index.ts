export { XRDraws } from './XRDraws';
