//! Roles of an enum of kinds, implemented by the fields of each kind.

use proc_macro2::TokenStream as Tokens;
use quote::quote;
use syn::{Data, DeriveInput};

use crate::naming::snake_case;

/// Returns the implementation of `Assemble`: each kind assembles its elements and shows its tank.
pub fn assembly(item: &DeriveInput) -> Tokens {
    let name = &item.ident;
    let Data::Enum(data) = &item.data else { return Tokens::new() };
    let kinds: Vec<_> = data.variants.iter().map(|variant| &variant.ident).collect();
    quote! {
        impl<S: crate::scenario::leaf::Quantity> crate::scenario::assembly::assemble::Assemble<S> for #name<S> {
            fn assemble(
                &self,
                name: &str,
                at: crate::scenario::assembly::assemble::Surroundings<'_, S>,
            ) -> Result<Vec<crate::elements::AnyElement<S>>, crate::scenario::error::FieldError> {
                match self {
                    #(Self::#kinds(given) => given.assemble(name, at),)*
                }
            }

            fn tank(&self, name: &str, scenario: &crate::scenario::schema::Scenario<S>) -> Option<crate::elements::DrawnTank> {
                match self {
                    #(Self::#kinds(given) => given.tank(name, scenario),)*
                }
            }
        }
    }
}

/// Returns the implementation of `SetsInputs`: the inputs that each kind sets, with their fields prefixed by the kind's
/// name.
pub fn inputs(item: &DeriveInput) -> Tokens {
    let name = &item.ident;
    let Data::Enum(data) = &item.data else { return Tokens::new() };
    let kinds: Vec<_> = data.variants.iter().map(|variant| &variant.ident).collect();
    let in_files = kinds.iter().map(|kind| snake_case(&kind.to_string()));
    quote! {
        impl<S> crate::scenario::schema::SetsInputs for #name<S> {
            fn targets(&self) -> Vec<(String, &str)> {
                let (kind, targets) = match self {
                    #(Self::#kinds(given) => (#in_files, given.targets()),)*
                };
                targets.into_iter().map(|(field, input)| (format!("{kind}.{field}"), input)).collect()
            }
            fn sets_drives(&self) -> bool {
                match self {
                    #(Self::#kinds(given) => given.sets_drives(),)*
                }
            }
        }
    }
}
