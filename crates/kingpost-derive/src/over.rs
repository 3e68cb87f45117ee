//! The conversion of a type to another scalar.

use proc_macro2::TokenStream as Tokens;
use quote::{ToTokens, format_ident, quote};
use syn::{Data, DeriveInput, Error, Field, Fields, Ident, Result};

use crate::names_scalar;
use crate::naming::{SerdeNames, snake_case};

/// Returns the implementation of `OverScalar` for a type over a scalar `S`.
pub fn conversion(item: &DeriveInput) -> Result<Tokens> {
    let name = &item.ident;
    let scalar = item.generics.type_params().next().map(|parameter| &parameter.ident);
    let scalar = scalar.ok_or_else(|| Error::new_spanned(name, "a type over a scalar"))?;
    let arms = match &item.data {
        Data::Struct(data) => vec![arm(&quote!(#name), &data.fields, scalar, None)?],
        Data::Enum(data) => {
            let arm = |variant: &syn::Variant| {
                let (ident, in_files) = (&variant.ident, snake_case(&variant.ident.to_string()));
                arm(&quote!(#name::#ident), &variant.fields, scalar, Some(&in_files))
            };
            data.variants.iter().map(arm).collect::<Result<_>>()?
        }
        Data::Union(_) => return Err(Error::new_spanned(name, "a struct or an enum")),
    };
    Ok(quote! {
        impl<#scalar: crate::scenario::leaf::Leaf> crate::scenario::over::OverScalar<#scalar> for #name {
            type Over = #name<#scalar>;
            fn over(&self, numbers: &mut dyn crate::scenario::over::Numbers<#scalar>) -> Self::Over {
                match self { #(#arms)* }
            }
        }
    })
}

/// Returns the match arm of one variant, or of a struct.
fn arm(path: &Tokens, fields: &Fields, scalar: &Ident, variant: Option<&str>) -> Result<Tokens> {
    let bound: Vec<Ident> = (0..fields.len()).map(|k| format_ident!("field_{k}")).collect();
    let converted = fields.iter().zip(&bound).map(|(field, bound)| converted(field, bound, scalar, variant));
    let converted: Vec<Tokens> = converted.collect::<Result<_>>()?;
    let (pattern, made) = match fields {
        Fields::Unit => (quote!(#path), quote!(#path)),
        Fields::Unnamed(_) => (quote!(#path(#(#bound),*)), quote!(#path(#(#converted),*))),
        Fields::Named(named) => {
            let names: Vec<_> = named.named.iter().map(|field| &field.ident).collect();
            (quote!(#path { #(#names: #bound),* }), quote!(#path { #(#names: #converted),* }))
        }
    };
    Ok(quote!(#pattern => #made,))
}

/// Returns a field, or the fields of a variant, converted to the other scalar.
fn converted(field: &Field, bound: &Ident, scalar: &Ident, variant: Option<&str>) -> Result<Tokens> {
    if !names_scalar(field.ty.to_token_stream(), scalar) {
        return Ok(quote!(#bound.clone()));
    }
    let name = match (&field.ident, variant) {
        (Some(name), _) => SerdeNames::of(&field.attrs)?.in_files(name),
        (None, Some(variant)) => variant.to_owned(),
        (None, None) => return Ok(quote!(crate::scenario::over::OverScalar::over(#bound, numbers))),
    };
    Ok(quote!(crate::scenario::over::within(#bound, &#name, numbers)))
}
