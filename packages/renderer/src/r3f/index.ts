export { Farol, type FarolProps } from './Farol';
