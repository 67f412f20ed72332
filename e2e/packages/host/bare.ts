export { FarolRenderer } from '@farol/renderer';
